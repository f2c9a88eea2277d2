// The names in a folder, in UTF-8.
#pragma once

struct dirent {
  char d_name[1024];
};
struct DIR;
DIR* opendir(const char* name);
DIR* fdopendir(int folder);
dirent* readdir(DIR* list);
int closedir(DIR* list);
