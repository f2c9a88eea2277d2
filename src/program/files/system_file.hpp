// Calls of the system on files that go on after interruptions, in the order that leaves whole files after a crash: the data,
// the name, the folder of the name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace app {

// Descriptors 0 to 2 that nobody has opened lead to nothing, before an output gets one of them: what is read there is empty,
// and what is written fails.
void open_standard_files();

// A descriptor that is closed on exec; below 0 with errno. Only a terminating signal ends the wait.
int open_file(const std::string& path, int flags);

// All of these return 0 or errno.
int read_all(int file, std::string& text);        // appends to `text`, up to an error
int read_from_start(int file, std::string& text); // the same of all of it; where the next write goes stays
int write_all(int file, std::string_view text);
int sync_file(int file);
int close_file(int file); // interrupted or not, it is closed
// The names in a folder. What cannot sync folders has no need of it: no failure.
int sync_folder(const std::string& folder);
int read_file(const std::string& path, std::string& text);
// A file that an option or a sketch names, whoever wrote it: a regular one of at most 64 MiB. Empty, or why it was not read.
std::string read_named(const std::string& path, std::string& text);
std::string read_text(int file, std::string& text); // empty, or why it was not read

int list_folder(const std::string& folder, std::vector<std::string>& names); // but . and ..

// System message of an errno. Exhausted memory throws std::bad_alloc as elsewhere.
std::string system_text(int code);

// The folder that a path lies in, without the slash at its end but for "/"; "." if it has none.
std::string folder_of(const std::string& path);
// Where the name in its folder begins; and whether the path leads to the same place from everywhere.
size_t begin_of_name(const std::string& path);
bool is_absolute(const std::string& path);

} // namespace app
