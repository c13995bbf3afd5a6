// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// curve_file: the curves that gnuplot draws, as one binary file beside its scripts.
//
// A curve is a block of pairs of little-endian 32-bit floats, x and y; NaN leaves a gap. Each has
// its own samples: as few as show it to a fraction of a pixel, with every peak. Scripts name a
// curve by a macro, `plot @truth_p_WC_x_m with lines`, that tells where its block is.

#include <limits>
#include <map>
#include <string>
#include <vector>

namespace sidestep::plot {

/// A point of a curve.
struct Sample {
  double x{0.0};
  double y{0.0};
};

/// The range of some values; empty until one is included. What is not finite is passed over.
struct Span {
  double min{std::numeric_limits<double>::infinity()};
  double max{-std::numeric_limits<double>::infinity()};

  bool is_empty() const { return !(min <= max); }
  double length() const { return is_empty() ? 0.0 : max - min; }
  void Include(double value);
  void Include(const Span& other);
};

/// Thins y over an ascending x. No sample is farther from the lines between the kept ones than a
/// 2000th of the curve's width and height, or, where more samples fall on a column of pixels than
/// a picture can show, than that column's own first, lowest, highest and last. Ends, lowest and
/// highest are kept.
std::vector<Sample> ThinGraph(const std::vector<Sample>& samples);

/// The same of a path in a plane, which may turn back.
std::vector<Sample> ThinPath(const std::vector<Sample>& samples);

class CurveFile {
 public:
  /// @param file    Its name, in the scripts' folder.
  /// @param prefix  Of the macros' names, where a script draws from two files.
  explicit CurveFile(std::string file, std::string prefix = {});
  CurveFile() : CurveFile("curves.bin") {}

  /// Adds a curve as it is. A name is added once.
  void Add(const std::string& name, const std::vector<Sample>& samples);

  bool Has(const std::string& name) const { return curves_.count(name) > 0; }

  /// How a script names the curve: `@truth_p_WC_x_m`. Precondition: it was added.
  std::string Macro(const std::string& name) const;

  /// The lines that define the macros which `script` uses.
  std::string Definitions(const std::string& script) const;

  /// Where the curve's values lie; empty if none is finite. Precondition: it was added.
  const Span& XOf(const std::string& name) const { return At(name).x; }
  const Span& YOf(const std::string& name) const { return At(name).y; }

  const std::string& file() const { return file_; }
  const std::string& bytes() const { return bytes_; }

 private:
  struct Curve {
    std::string macro;  ///< Letters, digits and underscores, whatever is in the curve's name.
    std::size_t first_byte{0};
    std::size_t records{0};
    Span x;
    Span y;
  };
  const Curve& At(const std::string& name) const;
  std::string FreeMacro(const std::string& name) const;

  std::string file_;
  std::string prefix_;
  std::string bytes_;
  std::map<std::string, Curve> curves_;
};

}  // namespace sidestep::plot
