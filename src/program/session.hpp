// Common part of run and check: a deck, its sizes, a workspace, and a solver with the model.
#pragma once

#include "program/commands/drawn_deck.hpp"
#include "program/commands/job.hpp"
#include "program/files/deck_file.hpp"
#include "program/messages.hpp"
#include "program/workspace.hpp"

#include <contact2d.h>

#include <string>
#include <vector>

namespace app {

class Session {
public:
  Session() : messages(deck) {}
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // Each step prints its faults and returns the exit status of the program; 0: continue.
  // The deck, or that of a sketch, into memory, and every fault of its cards.
  int read_file(const std::string& name, const Drawing& drawing);
  // The same of a text, whose solver ends with the program's other ones: signals do not stop it by itself.
  int read_text(const std::string& name, const std::string& text, const Drawing& drawing);
  // The deck of a job, or the sketch.
  int take_job(const Job& job, const Drawing& drawing);
  int take_memory(uint64_t wanted, int32_t elimination = C2D_ELIMINATION_DENSE); // workspace; 0 bytes wanted: chosen by size
  int read_model(const c2d_port& port, int32_t symmetry = C2D_SYMMETRY_DECK);    // the solver, and the model in it
  // Both in the minimum memory, for a model that is not solved.
  int read_model_alone(int32_t symmetry = C2D_SYMMETRY_DECK);
  c2d_error last_error() const;
  // Prints the reason of the last failed call of the library; returns the exit status.
  int failed(c2d_status status);

  DeckFile deck;
  Messages messages;
  std::vector<c2d_body_limits> bodies;
  c2d_limits limits = C2D_INIT(c2d_limits); // `body` is the list above
  Workspace workspace;
  c2d_solver* solver = nullptr;
  MeshLoop meshes; // how the mesh of a sketch was found

private:
  int take_cards(const Drawing* drawing); // null: the text is a deck
  bool is_one_of_many_ = false;
};

} // namespace app
