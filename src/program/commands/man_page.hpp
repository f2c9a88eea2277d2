// The page for `man`, made from the tables of commands, options, exit statuses and families.
#pragma once

#include <string>

namespace app {

// The page in the language of man(7); make man keeps it as port/packaging/contact2d.1.in.
std::string man_page(const std::string& version);

} // namespace app
