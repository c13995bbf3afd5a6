// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/xml_tree.h"

#include <gtest/gtest.h>

#include "models/support/xml_bounds.h"
#include "tests/support/temp_folder.h"

namespace sidestep::importer {
namespace {

XmlTree TreeOf(const std::filesystem::path& file) { return ReadXmlTree(file, MeshFiles(file, {})); }

TEST(XmlTree, WhatIsIncludedStandsInItsPlaceAndKnowsItsPlace) {
  const TempFolder folder;
  const std::filesystem::path main =
      folder.Write("scene.xml", "<mujoco>\n<a/>\n<include file=\"parts/b.xml\"/>\n<c/></mujoco>");
  folder.Write("parts/b.xml", "<mujoco>\n\n<b x=\"1 &lt; 2\"/><include file=\"d.xml\"/></mujoco>");
  folder.Write("parts/d.xml", "<mujocoinclude><d/></mujocoinclude>");
  const XmlTree tree = TreeOf(main);
  ASSERT_EQ(tree.root.children.size(), 4U);
  EXPECT_EQ(tree.root.children[1].tag, "b");
  EXPECT_EQ(tree.root.children[2].tag, "d");
  EXPECT_EQ(tree.root.children[3].tag, "c");
  EXPECT_EQ(tree.Place(tree.root.children[1]), (folder.path() / "parts/b.xml:3:1").string());
  EXPECT_EQ(XmlText(tree.root.children[1], nullptr), "<b x=\"1 &lt; 2\"/>\n");
}

TEST(XmlTree, LinesOfTheTextTellTheirElements) {
  XmlElement root{"a", {}, {{"b", {}, {}, 0, 7}, {"c", {}, {{"d", {}, {}, 0, 9}}, 0, 8}}, 0, 5};
  std::vector<const XmlElement*> lines;
  EXPECT_EQ(XmlText(root, &lines), "<a>\n<b/>\n<c>\n<d/>\n</c>\n</a>\n");
  std::vector<int> numbers;
  for (const XmlElement* element : lines) numbers.push_back(element->place.line);
  EXPECT_EQ(numbers, (std::vector<int>{5, 7, 8, 9, 8, 5}));
}

TEST(XmlTree, IncludesThatLoopOrLeaveTheFolderOrAreMissingAreAllTold) {
  const TempFolder folder;
  folder.Write("secret.xml", "<mujoco/>");
  const std::filesystem::path main = folder.Write(
      "in/scene.xml",
      "<mujoco>\n<include file=\"scene.xml\"/>\n<include file=\"../secret.xml\"/>\n<include "
      "file=\"none.xml\"/>\n<include/>\n</mujoco>");
  const std::string error = folder.ErrorOf([&] { TreeOf(main); });
  EXPECT_NE(error.find("scene.xml:2:1: error: <include file=\"scene.xml\"> includes itself"),
            std::string::npos)
      << error;
  EXPECT_NE(error.find("scene.xml:3:1: error: <include file=\"../secret.xml\"> outside"),
            std::string::npos)
      << error;
  EXPECT_NE(error.find("scene.xml:4:1: error: <include file=\"none.xml\"> no such file"),
            std::string::npos)
      << error;
  EXPECT_NE(error.find("scene.xml:5:1: error: <include file=\"\"> "), std::string::npos) << error;
}

TEST(XmlTree, FilesThatIncludeAThousandTimesEndInOneLine) {
  const TempFolder folder;
  folder.Write("leaf.xml", "<mujoco/>");
  std::string text = "<mujoco>";
  for (int i = 0; i < 1001; ++i) text += "<include file=\"leaf.xml\"/>";
  const std::filesystem::path main = folder.Write("scene.xml", text + "</mujoco>");
  EXPECT_NE(folder.ErrorOf([&] { TreeOf(main); }).find("is one file too many"), std::string::npos);
}

TEST(XmlTree, BytesOfAllFilesAreCounted) {
  const TempFolder folder;
  const std::string half(kMaxXmlBytes / 2, ' ');
  folder.Write("leaf.xml", "<mujoco>" + half + "</mujoco>");
  const std::filesystem::path main = folder.Write(
      "scene.xml", "<mujoco><include file=\"leaf.xml\"/><include file=\"leaf.xml\"/></mujoco>");
  EXPECT_EQ(
      folder.ErrorOf([&] { TreeOf(main); }),
      "scene.xml:1:35: error: <include file=\"leaf.xml\"> is too much: an MJCF may have 64 MiB, "
      "with the files that it includes");
}

TEST(XmlTree, DeepFilesInsideDeepFilesEndInOneLine) {
  const TempFolder folder;
  for (int i = 0; i < 5; ++i) {
    std::string text = "<mujoco>";
    for (int k = 0; k < 90; ++k) text += "<body>";
    text += "<include file=\"f" + std::to_string(i + 1) + ".xml\"/>";
    for (int k = 0; k < 90; ++k) text += "</body>";
    folder.Write("f" + std::to_string(i) + ".xml", text + "</mujoco>");
  }
  folder.Write("f5.xml", "<mujoco/>");
  EXPECT_NE(folder.ErrorOf([&] { TreeOf(folder.path() / "f0.xml"); }).find("too deep"),
            std::string::npos);
}

}  // namespace
}  // namespace sidestep::importer
