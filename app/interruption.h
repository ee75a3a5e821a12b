#pragma once

#include <functional>
#include <string>

namespace geneva::app {

/// What the other ranks of a run have to do with the end of this one.
struct OtherRanks {
  std::function<void()> look;    ///< at how they are, every tenth of a second; may be empty
  std::function<bool()> speaks;  ///< whether this one says that the run was interrupted
};

/// From here on SIGINT, SIGTERM and SIGHUP end the process within moments: what is half done is put
/// away (base::Undo), rank 0 says so, and the exit code is 128 and the signal's number. A second
/// signal ends it at once.
///
/// A thread waits for them, so that no computation has to look. To be called before other threads
/// start, which inherit that the signals do not interrupt them.
void watch_for_interruption(OtherRanks others);

/// What is said beside when the process is interrupted from here on: how to go on.
void say_if_interrupted(const std::string& advice);

/// From here on an exception that nothing can catch, in the end of a library's object, ends the
/// process with a sentence, too: with exit code 2 if memory ran out, else 3.
/// @param about as in exit_code_of()
void watch_for_termination(const std::string& about);

/// Ends the process at once, from any thread, after watch_for_termination(): memory ran out, and no
/// exception can say so.
[[noreturn]] void end_for_memory();

}  // namespace geneva::app
