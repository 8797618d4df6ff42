// SPDX-License-Identifier: MIT
// A number that others have published, and the run that has to give it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/validate/bench.h"

namespace pabd::validate {

// What a run gave.
struct Outcome {
  double value = 0;  // in the unit of the case
  // For its figure, over `Case::x_label`: the program's, and what is published. Empty: the case has one number only.
  std::vector<double> x, ours, published;

  void see(double at, double our) {
    x.push_back(at);
    ours.push_back(our);
  }
  void see(double at, double our, double right) {
    see(at, our);
    published.push_back(right);
  }
};

// How far from the published value the program may be with such a step.
struct Tolerance {
  double h;       // s
  double margin;  // in the unit of the case
};

struct Case {
  std::string key;  // "pendulum-period"
  double published;
  std::function<Outcome(Bench&)> measure;
  // Of the table in cases.md.
  std::string what = {};              // "a pendulum let go from the horizontal: period"
  std::string unit = {};              // "1" for a plain number
  std::string source = {};            // whose number it is; "computed here: …" where nobody has printed it
  std::vector<Tolerance> steps = {};  // coarse to fine
  std::string x_label = {}, y_label = {};  // of the figure
};

// By subject, in the order of the table.
void add_pendulums(std::vector<Case>& cases);
void add_spins(std::vector<Case>& cases);
void add_linkages(std::vector<Case>& cases);
void add_rolling(std::vector<Case>& cases);
void add_contacts(std::vector<Case>& cases);
void add_structures(std::vector<Case>& cases);

}  // namespace pabd::validate
