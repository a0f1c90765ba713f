#pragma once
/// \file
/// How a library was asked a case, in its own language and with its own numbers: what a bug report shows. It
/// is stated beside the call, so that the call and its reproduction stay together.
///
///     peers::LibraryCall call("vtkBox::IntersectBox", R"(#include <vtkBox.h>
///     double origin[] = {$origin}, t = 0;
///     char hit = vtkBox::IntersectBox(…, origin, …, t);
///     std::printf("hit = %d, t = $g\n", hit, t);)", given("origin", origin));
///     call.ask();                                   // before the library is called: it may not return
///     …
///     call.said(given("hit", hit), given("t", t));  // what that program is to print
///
/// `$NAME` stands for the numbers given by that name, `$T` for float or double, `$g` for the conversion of
/// printf that shows all digits. Lines that begin with # or `namespace` stand before main. In a check nothing
/// of this is done; `--reproduce` asks for it, and `--about` for the library and its version.

#include <cstdlib>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "answer_cases.hpp"
#include "peers/source_text.hpp"

namespace rayproof::peers {

/// The library that a program asks.
struct Library {
  std::string name{};
  std::string version{};  ///< as the library itself says it
  std::string build{};    ///< the shell line that makes `reproduction` of reproduction.cpp, and runs it
  std::string tracker{};  ///< where its makers take reports
  /// What its documentation says of some faults: words of "property: diagnosis", and a sentence.
  std::vector<std::pair<std::string, std::string>> documented{};
};

/// Whether the program was asked to show how it calls the library.
inline bool is_reproducing = false;

/// Reads the arguments of a peer's program; the program ends here where it is asked about its library alone.
inline void introduce(int count, char** arguments, const Library& library) {
  for (int i = 1; i < count; ++i) {
    const std::string_view argument = arguments[i];
    is_reproducing |= argument == "--reproduce";
    if (argument != "--about") continue;
    std::string documented;
    for (const auto& [fault, sentence] : library.documented)
      documented += (documented.empty() ? "" : ", ") + ("{\"fault\": " + json_text(fault)) +
                    ", \"sentence\": " + json_text(sentence) + "}";
    answering::write_all(STDOUT_FILENO, "{\"library\": " + json_text(library.name) +
                                            ", \"version\": " + json_text(library.version) +
                                            ", \"build\": " + json_text(library.build) +
                                            ", \"tracker\": " + json_text(library.tracker) +
                                            ", \"documented\": [" + documented + "]}\n");
    std::exit(0);
  }
}

/// What builds and runs a reproduction in C++ with these flags.
[[nodiscard]] inline std::string built_with(const std::string& flags) {
  return "g++ -std=c++17 -O2 reproduction.cpp -o reproduction" + (flags.empty() ? "" : " " + flags) +
         " && ./reproduction";
}

/// One call of the library.
class LibraryCall {
 public:
  template <class... V>
  LibraryCall(std::string_view function, std::string_view body, const Given<V>&... inputs) {
    if (!is_reproducing) return;
    function_ = function;
    add(body, inputs...);
  }

  /// Goes on with more lines and numbers.
  template <class... V>
  void add(std::string_view body, const Given<V>&... inputs) {
    if (!is_reproducing) return;
    if (!body_.empty()) body_ += '\n';
    body_ += body;
    (add_input(inputs), ...);
  }

  /// Shows the reproduction. From now on the library may do what it likes.
  void ask() const {
    if (!is_reproducing) return;
    answering::write_all(STDOUT_FILENO, "{\"function\": " + json_text(function_) +
                                            ", \"source\": " + json_text(program_of(body_)) +
                                            ", \"inputs\": {" + inputs_ + "}}\n");
  }

  /// Shows what the library said, as the reproduction prints it.
  template <class... V>
  void said(const Given<V>&... outputs) const {
    if (!is_reproducing) return;
    std::string printed, numbers;
    ((printed +=
      (printed.empty() ? "" : ", ") + std::string(outputs.name) + " = " + as_printed(outputs.value),
      numbers += (numbers.empty() ? "" : ", ") + json_text(outputs.name) + ": " + as_json(outputs.value)),
     ...);
    answering::write_all(STDOUT_FILENO,
                         "{\"printed\": " + json_text(printed) + ", \"said\": {" + numbers + "}}\n");
  }

 private:
  template <class V>
  void add_input(const Given<V>& input) {
    body_ = replaced(std::move(body_), "$" + std::string(input.name), as_source(input.value));
    if constexpr (!std::is_same_v<NumberOf<V>, void>) {
      constexpr bool is_float = std::is_same_v<NumberOf<V>, float>;
      body_ = replaced(replaced(std::move(body_), "$T", is_float ? "float" : "double"), "$g",
                       is_float ? "%.9g" : "%.17g");
    }
    inputs_ += (inputs_.empty() ? "" : ", ") + json_text(input.name) + ": " + as_json(input.value);
  }

  std::string function_{}, body_{}, inputs_{};
};

}  // namespace rayproof::peers
