// SPDX-License-Identifier: BSD-3-Clause
// text_mutator: how libFuzzer varies inputs here: half of the time by bytes, as ever, else as a
// person could: another number, a line more or less, a word in another's place.

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace sidestep::fuzz {
namespace {

// Ends of ranges, of types and of patience.
constexpr std::array<std::string_view, 30> kOddNumbers{"0",
                                                       "-0",
                                                       "1",
                                                       "-1",
                                                       "2",
                                                       "3",
                                                       "0.5",
                                                       "1e-9",
                                                       "1e-13",
                                                       "1e-300",
                                                       "5e-324",
                                                       "1e9",
                                                       "1e17",
                                                       "-1e17",
                                                       "1e308",
                                                       "-1e308",
                                                       "1e309",
                                                       "2147483647",
                                                       "-2147483648",
                                                       "4294967295",
                                                       "9223372036854775807",
                                                       "18446744073709551616",
                                                       "65536",
                                                       "1000000",
                                                       "nan",
                                                       ".nan",
                                                       "inf",
                                                       "-.inf",
                                                       "null",
                                                       "0x7f"};

using Span = std::pair<std::size_t, std::size_t>;  // begin and end

bool IsOfNumber(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '+';
}
bool IsOfWord(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '-';
}

template <typename Belongs>
std::vector<Span> RunsOf(const std::string& text, Belongs&& belongs) {
  std::vector<Span> runs;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (!belongs(text[at])) continue;
    const bool goes_on = !runs.empty() && runs.back().second == at;
    if (goes_on) {
      ++runs.back().second;
    } else {
      runs.emplace_back(at, at + 1);
    }
  }
  return runs;
}

std::vector<Span> LinesOf(const std::string& text) {
  std::vector<Span> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
    lines.emplace_back(at, end);
    at = end;
  }
  return lines;
}

class Editor {
 public:
  Editor(std::string text, unsigned seed) : text_(std::move(text)), random_(seed) {}

  const std::string& text() const { return text_; }

  void EditOnce() {
    switch (Below(6)) {
      case 0:
      case 1:
        return ReplaceNumber();
      case 2:
        return ReplaceWord();
      case 3:
        return DropLine();
      case 4:
        return CopyLines();
      default:
        return SwapLines();
    }
  }

 private:
  std::size_t Below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }
  std::string At(const Span& span) const {
    return text_.substr(span.first, span.second - span.first);
  }
  void Put(const Span& span, std::string_view text) {
    text_.replace(span.first, span.second - span.first, text);
  }

  void ReplaceNumber() {
    const std::vector<Span> numbers = RunsOf(text_, IsOfNumber);
    if (!numbers.empty())
      Put(numbers[Below(numbers.size())], kOddNumbers[Below(kOddNumbers.size())]);
  }
  void ReplaceWord() {
    const std::vector<Span> words = RunsOf(text_, IsOfWord);
    if (!words.empty()) Put(words[Below(words.size())], At(words[Below(words.size())]));
  }
  void DropLine() {
    const std::vector<Span> lines = LinesOf(text_);
    if (!lines.empty()) Put(lines[Below(lines.size())], "");
  }
  // A block of up to eight lines, to anywhere.
  void CopyLines() {
    const std::vector<Span> lines = LinesOf(text_);
    if (lines.empty()) return;
    const std::size_t first = Below(lines.size());
    const std::size_t last = std::min(first + Below(8), lines.size() - 1);
    text_.insert(lines[Below(lines.size())].first, At({lines[first].first, lines[last].second}));
  }
  void SwapLines() {
    const std::vector<Span> lines = LinesOf(text_);
    if (lines.empty()) return;
    Span first = lines[Below(lines.size())], second = lines[Below(lines.size())];
    if (first > second) std::swap(first, second);
    const std::string moved = At(second);
    Put(second, At(first));
    Put(first, moved);
  }

  std::string text_;
  std::mt19937 random_;
};

}  // namespace
}  // namespace sidestep::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  constexpr unsigned kMostEdits = 4;
  if (seed % 2 == 0) return LLVMFuzzerMutate(data, size, max_size);
  sidestep::fuzz::Editor editor({reinterpret_cast<const char*>(data), size}, seed);
  for (unsigned edits = 1 + seed / 2 % kMostEdits; edits > 0; --edits) editor.EditOnce();
  const std::size_t new_size = std::min(editor.text().size(), max_size);
  std::memcpy(data, editor.text().data(), new_size);
  return new_size;
}
