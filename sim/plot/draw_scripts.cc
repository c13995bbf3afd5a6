// SPDX-License-Identifier: BSD-3-Clause
#include "sim/plot/draw_scripts.h"

#include <set>
#include <system_error>

#include "models/support/config_error.h"
#include "sim/process/gnuplot.h"

namespace sidestep::plot {
namespace {

namespace fs = std::filesystem;

constexpr char kUnfinished[] = ".part";

/// Pictures while gnuplot draws them: they take their names when all are whole, or go.
class UnfinishedPictures {
 public:
  explicit UnfinishedPictures(const std::vector<fs::path>& pictures) : pictures_(pictures) {}
  UnfinishedPictures(const UnfinishedPictures&) = delete;
  UnfinishedPictures& operator=(const UnfinishedPictures&) = delete;
  ~UnfinishedPictures() {
    std::error_code ignored;
    for (const fs::path& picture : pictures_) fs::remove(PartOf(picture), ignored);
  }

  void Finish() const {
    std::error_code failure;
    for (const fs::path& picture : pictures_) {
      fs::rename(PartOf(picture), picture, failure);
      if (!failure) continue;
      throw ConfigError(picture.string() + ": error: can't be written: " + failure.message());
    }
  }

 private:
  static fs::path PartOf(const fs::path& picture) { return picture.string() + kUnfinished; }

  const std::vector<fs::path>& pictures_;
};

}  // namespace

std::vector<fs::path> DrawScripts(const std::vector<std::string>& names,
                                  const std::vector<std::string>& formats, const fs::path& folder) {
  std::vector<std::string> words{"-e", std::string("ending='") + kUnfinished + "'"};
  std::vector<fs::path> pictures;
  for (const std::string& format : std::set<std::string>(formats.begin(), formats.end())) {
    words.insert(words.end(), {"-e", "format='" + format + "'"});
    for (const std::string& name : names) {
      words.push_back(name + ".gp");
      pictures.push_back(folder / (name + "." + format));
    }
  }
  const UnfinishedPictures unfinished(pictures);
  RunGnuplot(words, {}, folder);
  unfinished.Finish();
  return pictures;
}

}  // namespace sidestep::plot
