// SPDX-License-Identifier: BSD-3-Clause
#include "sim/export/mat_file.h"

#include <matio.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <memory>
#include <new>
#include <system_error>
#include <utility>

#include "sim/export/hdf5_failures.h"
#include "sim/export/mat_names.h"
#include "sim/record/output_file.h"

namespace sidestep {
namespace {

namespace fs = std::filesystem;

constexpr char kRoot[] = "robot_logger_device";
constexpr char kHeader[] = "MATLAB 7.3 MAT-file, written by sidestep";

// What matio gave, or the memory that it lacked.
matvar_t* Given(matvar_t* variable) {
  if (variable == nullptr) throw std::bad_alloc();
  return variable;
}

struct FreeVariable {
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using Variable = std::unique_ptr<matvar_t, FreeVariable>;

template <std::size_t kRank>
Variable Numbers(const std::vector<double>& values, std::array<std::size_t, kRank> dims) {
  double* const read_only = const_cast<double*>(values.data());  // matio copies it
  return Variable(Given(Mat_VarCreate(nullptr, MAT_C_DOUBLE, MAT_T_DOUBLE, static_cast<int>(kRank),
                                      dims.data(), read_only, 0)));
}

Variable Text(const std::string& text) {
  std::vector<std::uint16_t> characters;
  for (const char c : text) characters.push_back(static_cast<unsigned char>(c));
  std::array<std::size_t, 2> dims{1, characters.size()};
  return Variable(Given(
      Mat_VarCreate(nullptr, MAT_C_CHAR, MAT_T_UINT16, 2, dims.data(), characters.data(), 0)));
}

// A column of texts. The cell owns them.
Variable Texts(const std::vector<std::string>& texts) {
  std::vector<Variable> owned;
  for (const std::string& text : texts) owned.push_back(Text(text));
  std::vector<matvar_t*> cells;
  for (const Variable& one : owned) cells.push_back(one.get());
  std::array<std::size_t, 2> dims{cells.size(), 1};
  Variable cell(
      Given(Mat_VarCreate(nullptr, MAT_C_CELL, MAT_T_CELL, 2, dims.data(), cells.data(), 0)));
  for (Variable& one : owned) static_cast<void>(one.release());
  return cell;
}

Variable EmptyStruct(const char* name) {
  std::array<std::size_t, 2> dims{1, 1};
  return Variable(Given(Mat_VarCreateStruct(name, 2, dims.data(), nullptr, 0)));
}

// Adds a field, which the struct owns from here on.
void AddField(const Variable& to, const std::string& name, Variable field) {
  if (Mat_VarAddStructField(to.get(), name.c_str()) != 0) throw std::bad_alloc();
  Mat_VarSetStructFieldByName(to.get(), name.c_str(), 0, field.release());
}

void AddSignal(const Variable& to, const Signal& signal, const std::vector<double>& time_s) {
  const std::size_t size = signal.values.size();
  std::vector<double> data;
  data.reserve(size * time_s.size());
  for (std::size_t row = 0; row < time_s.size(); ++row) {
    for (const std::vector<double>& element : signal.values) data.push_back(element[row]);
  }
  AddField(to, "data", Numbers<3>(data, {size, 1, time_s.size()}));
  AddField(to, "timestamps", Numbers<2>(time_s, {1, time_s.size()}));
  AddField(to, "dimensions", Numbers<2>({static_cast<double>(size), 1.0}, {2, 1}));
  AddField(to, "elements_names", Texts(signal.elements));
  AddField(to, "units_of_measure", Texts(signal.units));
  AddField(to, "name", Text(signal.group.back()));
}

using SignalIterator = std::vector<const Signal*>::const_iterator;

// Adds the signals of [begin, end), which share their first `depth` names, as structs in structs.
void AddTree(const Variable& to, SignalIterator begin, SignalIterator end, std::size_t depth,
             const std::vector<double>& time_s, MatNames names = {}) {
  while (begin != end) {
    const std::string& name = (*begin)->group[depth];
    const SignalIterator other = std::find_if(
        begin, end, [&](const Signal* signal) { return signal->group[depth] != name; });
    Variable inner = EmptyStruct(nullptr);
    SignalIterator deeper = begin;
    if ((*begin)->group.size() == depth + 1) AddSignal(inner, **deeper++, time_s);
    AddTree(inner, deeper, other, depth + 1, time_s);
    AddField(to, names.Take(name), std::move(inner));
    begin = other;
  }
}

const Signal* Find(const std::vector<Signal>& signals, const std::vector<std::string>& group) {
  const auto found = std::find_if(signals.begin(), signals.end(),
                                  [&](const Signal& signal) { return signal.group == group; });
  return found == signals.end() ? nullptr : &*found;
}

// What viewers draw the robot by: joints, and the pose of the base with the quaternion's w last.
MatNames AddRobot(const Variable& root, const MatContent& content) {
  MatNames names;
  const Signal* joints = Find(content.signals, {"joints_state", "positions"});
  AddField(root, names.Take("description_list"),
           Texts(joints == nullptr ? std::vector<std::string>() : joints->elements));
  AddField(root, names.Take("yarp_robot_name"), Text(content.robot_name));
  for (const auto& [from, to] :
       {std::pair{"position", "base_position"}, std::pair{"orientation", "base_orientation"}}) {
    const Signal* truth = Find(content.signals, {"truth", "base", from});
    if (truth == nullptr) continue;
    Signal base = *truth;
    base.group = {to};
    if (base.elements.front() == "w") {
      std::rotate(base.elements.begin(), base.elements.begin() + 1, base.elements.end());
      std::rotate(base.values.begin(), base.values.begin() + 1, base.values.end());
    }
    Variable field = EmptyStruct(nullptr);
    AddSignal(field, base, content.time_s);
    AddField(root, names.Take(to), std::move(field));
  }
  return names;
}

Variable Tree(const MatContent& content) {
  Variable root = EmptyStruct(kRoot);
  const MatNames names = AddRobot(root, content);
  std::vector<const Signal*> sorted;
  for (const Signal& signal : content.signals) sorted.push_back(&signal);
  std::sort(sorted.begin(), sorted.end(),
            [](const Signal* a, const Signal* b) { return a->group < b->group; });
  AddTree(root, sorted.begin(), sorted.end(), 0, content.time_s, names);
  return root;
}

// Throws as FailToWrite(file) if any of it failed.
void WriteTree(const Variable& root, const fs::path& part, const fs::path& file) {
  const Hdf5Failures failures;
  mat_t* mat = Mat_CreateVer(part.c_str(), kHeader, MAT_FT_MAT73);
  bool is_whole = mat != nullptr;
  is_whole = is_whole && Mat_VarWrite(mat, root.get(), MAT_COMPRESSION_ZLIB) == 0;
  is_whole = (mat == nullptr || Mat_Close(mat) == 0) && is_whole;
  if (is_whole && !failures.first()) return;
  errno = failures.first().value_or(0);
  FailToWrite(file);
}

}  // namespace

void WriteMat(const MatContent& content, const fs::path& file) {
  const fs::path part = file.string() + ".part";
  try {
    WriteTree(Tree(content), part, file);
    std::error_code failure;
    fs::rename(part, file, failure);
    if (!failure) return;
    errno = failure.value();
    FailToWrite(file);
  } catch (...) {
    std::error_code ignored;
    fs::remove(part, ignored);  // it would keep a full disk full
    throw;
  }
}

}  // namespace sidestep
