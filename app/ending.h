#pragma once

#include <mpi.h>

#include <string>

namespace geneva::app {

/// How ranks that have failed come to their end: all together, or, where others still compute and
/// wait for them, by ending those too.
class Ending {
 public:
  /// To be called by all ranks, before anything can fail.
  explicit Ending(MPI_Comm communicator);
  ~Ending();
  Ending(const Ending&) = delete;
  Ending& operator=(const Ending&) = delete;

  /// Says why, once for all ranks. Returns only if all ranks have failed.
  /// @param code that the program ends with
  void fail(int code, const std::string& text);

 private:
  [[nodiscard]] bool all_fail() const;
  [[nodiscard]] bool a_lower_rank_fails() const;
  void tell_others() const;

  MPI_Comm communicator_ = MPI_COMM_NULL;  ///< for failures alone
  int rank_ = 0;
  int ranks_ = 1;
};

/// What ranks of this machine know of a failure: asked without MPI, from any thread.
enum class FailureStage {
  none,
  said,   ///< by one of them, so that the others end without a word
  alone,  ///< by one that is going to end the others
  undone  ///< as before, and rank 0 has put away what is half done
};
FailureStage failure_on_this_machine();

/// Whether there are other ranks, and an Ending of them: from any thread.
bool knows_other_ranks();

/// For a rank that cannot get to its end (Ending::fail) any more, from any thread: has rank 0 put
/// away what is half done. The caller then ends the process, and the launcher the others.
/// @return whether there are other ranks, and none of them has said why the run ends
bool begin_to_end_alone();

/// By rank 0, when it has put away what is half done.
void note_that_all_is_undone();

}  // namespace geneva::app
