#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include "model/input/case_file.h"
#include "tests/support/private_directory.h"

namespace geneva::model::test {

/// A case directory that lives as long as the object.
class CaseDirectory {
 public:
  explicit CaseDirectory(const std::string& case_text) { write("case.prm", case_text); }

  void write(const std::string& name, const std::string& content) const {
    static_cast<void>(directory_.write(name, content));
  }
  [[nodiscard]] const std::filesystem::path& path() const { return directory_.path(); }
  [[nodiscard]] Case read() const { return read_case(path()); }

  /// Message of the refusal, in which DIR stands for the directory; "accepted" if there is none.
  [[nodiscard]] std::string refusal() const {
    try {
      read_case(path());
      return "accepted";
    } catch (const std::invalid_argument& error) {
      std::string message = error.what();
      for (std::size_t place = message.find(path().string()); place != std::string::npos;
           place = message.find(path().string()))
        message.replace(place, path().string().size(), "DIR");
      return message;
    }
  }

 private:
  geneva::test::PrivateDirectory directory_;
};

/// Message of the refusal of a case text; "accepted" if there is none.
inline std::string refusal(const std::string& case_text) {
  return CaseDirectory(case_text).refusal();
}

/// The smallest mechanism case, with more lines in its subsection (the first is line 6) and after
/// it.
inline std::string mechanism_text(const std::string& inside = "", const std::string& after = "") {
  return "subsection Mechanism\n"
         "  set Stations = 6\n"
         "  set Wheel diameter = 4.53 in\n"
         "  set Driver speed = 600 rpm\n"
         "  set Load inertia = 0.0046 lbf.s^2.in\n" +
         inside + "end\n" + after;
}

}  // namespace geneva::model::test
