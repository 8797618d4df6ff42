// SPDX-License-Identifier: MIT
// The PDF is whole, one page of the right size, and holds its font.
#include <catch2/catch.hpp>

#include "app/plots/figure.h"
#include "app/plots/figures/barrier_curves.h"
#include "app/plots/figures/contact_pair.h"

namespace pabd::test_pdf {

namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("a PDF has one page of the picture's size and the font in it") {
  const std::string figure = picture_to_pdf(figure_picture(figure1()), 1600, 700);
  const std::string drawing = picture_to_pdf(figure5(), 1600, 800);
  for (const std::string* pdf : {&figure, &drawing}) {
    CHECK(pdf->starts_with("%PDF-1."));
    CHECK(pdf->find("%%EOF") > pdf->size() - 10);
    CHECK(count(*pdf, "/Type /Page") - count(*pdf, "/Type /Pages") == 1);
    CHECK(count(*pdf, "+DejaVuSans") >= 1);  // "+": a subset that is embedded
    CHECK(count(*pdf, "/FontFile") >= 1);
    CHECK(count(*pdf, "/ToUnicode") >= 1);  // what is copied out of it is text
    CHECK(pdf->size() < 200000);
    CHECK(count(*pdf, "/CreationDate") == 0);
  }
  CHECK(figure.find("0 0 1200 525") != std::string::npos);
  CHECK(drawing.find("0 0 1200 600") != std::string::npos);
}

}  // namespace pabd::test_pdf
