// What a run leaves beside its tapes so that `resume` can go on after a crash: the deck and the options.
#pragma once

#include "program/options.hpp"
#include "report/stated.hpp"

#include <cstdint>
#include <string>

namespace app {

// Writes FOLDER/deck.dat, FOLDER/points.csv if there is a file of points, FOLDER/meshes if errors were stated, and
// FOLDER/options: what was asked for, with names of files made absolute, and the workspace that was taken. `options` appears
// last and whole. False with an error text on failure.
bool leave_restart(const std::string& folder, const Options& options, const std::string& deck_name,
                   const std::string& deck_text, const std::string& points_text, const MeshLoop& meshes, uint64_t workspace,
                   std::string& error);

// The options of the run that was left in options.folder, for run_deck; what the command line says of progress stays.
// False with an error text if there is none.
bool read_restart(Options& options, std::string& error);

// What was stated beside the deck that is in the folder; nothing if nothing was. False with an error text if it is damaged.
bool read_kept_meshes(const std::string& folder, MeshLoop& out, std::string& error);

// Removes these files; those that are not there are no failure.
bool remove_restart(const std::string& folder, std::string& error);

} // namespace app
