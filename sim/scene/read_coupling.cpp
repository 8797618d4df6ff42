// SPDX-License-Identifier: MIT
// "follows" and "lead": joints that are coupled to others, or whose offset is coupled to their angle. See read_joint.h.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <unordered_map>

#include "sim/scene/read_joint.h"
#include "sim/scene/text.h"
#include "sim/solver/couplings.h"

namespace pabd {
namespace {

constexpr double kTogether = 1e-6;  // rad or m: by how much joints may miss a stated offset where they start

bool turns(const JointMeasure& measure) { return measure.of == JointMeasure::Of::angle; }

void refuse_zero(const ObjectReader& in, std::string_view key, double ratio) {
  if (ratio == 0) in.fail_key(key, "is 0; expected another number, or \"fixed\" in place of the joint");
}

// The keys of "follows"; the name of the other joint enters the hash as its number.
struct LeaderFields : FieldReader {
  using Find = std::function<Index(const Node&)>;
  LeaderFields(const ObjectReader& in, Find number) : FieldReader(in), find(std::move(number)) {}
  using FieldReader::operator();
  void operator()(const Field& field, std::string&) const {
    in_.record(field.key, static_cast<double>(find(in_.require(field.key, "the name of another joint"))));
  }
  Find find;
};

class CouplingReader {
 public:
  // `list` is "joints", whose first is joint `first` of the model.
  CouplingReader(const Node& list, std::size_t first, ModelBuilder& out)
      : list_(list), first_(first), out_(out) {}

  void read(std::size_t k) {
    const Node node = list_.element(k);
    const bool follows = node.value().contains("follows"), screw = node.value().contains("lead");
    Joint& joint = out_.model.joints[first_ + k];
    const ObjectReader in(node, keys_of_joint(joint.type));
    const char* key = follows ? "follows" : "lead";
    if (follows && screw)
      in.fail_key("lead", "a joint follows its own angle or another joint; remove this key or \"follows\"");
    if (joint.drive)
      in.fail_key(
          key, fmt::format("a driven joint goes as its drive says; remove one of \"{}\" and \"drive\"", key));
    JointCoupling coupling;
    if (screw) {
      spec::Joint entry;
      entry.type = joint.type;
      entry.coupling_fields(FieldReader(in));
      refuse_zero(in, "lead", *entry.lead);
      coupling.leader = static_cast<Index>(first_ + k);
      coupling.ratio = *entry.lead / (2 * kPi);
      if (joint.twist == Twist::locked)
        in.fail_key("lead", "its \"twist\" is locked, so that it cannot move");
      finish(coupling, {}, true, in, joint);
      return;
    }
    const bool angle = turns(*coupled_measure(joint));
    static const auto kKeys = keys_of_entry(spec::Follows{});
    const ObjectReader of(*in.find("follows"), kKeys);
    spec::Follows entry;
    entry.fields(
        LeaderFields(of, [&](const Node& leader) { return coupling.leader = number_of(leader, joint); }),
        angle);
    refuse_zero(of, "ratio", entry.ratio);
    coupling.ratio = entry.ratio;
    finish(coupling, entry.offset ? std::optional(*entry.offset * (angle ? kDegree : 1)) : std::nullopt,
           in.has("frames"), of, joint);
  }

 private:
  Index number_of(const Node& node, const Joint& joint) {
    if (numbers_.empty())
      for (std::size_t k = 0; k < out_.model.joints.size(); ++k)
        numbers_.emplace(out_.model.joints[k].name, static_cast<Index>(k));
    const std::string name = node.name();
    const auto at = numbers_.find(name);
    if (at == numbers_.end()) {
      std::vector<std::string_view> known;
      for (const auto& [each, number] : numbers_) known.push_back(each);
      std::sort(known.begin(), known.end());
      node.fail(fmt::format("no joint is named {}{}", in_quotes(name), did_you_mean(name, known)));
    }
    const Joint& leader = out_.model.joints[static_cast<std::size_t>(at->second)];
    if (&leader == &joint)
      node.fail("a joint cannot follow itself; \"lead\" couples its offset to its angle");
    if (!coupled_measure(leader))
      node.fail(fmt::format("{} is {}; expected a hinge, slider or cylindrical joint", in_quotes(name),
                            to_string(leader.type)));
    return at->second;
  }

  // The offset that a scene does not state is that of the start.
  // A scene that was saved in mid-run, which has "frames", may be off by what pulls there.
  void finish(JointCoupling coupling, const std::optional<double>& offset, bool stands_anywhere,
              const ObjectReader& in, Joint& joint) {
    coupling.offset = offset.value_or(0);
    joint.follows = coupling;
    const double error = coupling_error(out_.model, out_.state, joint);
    if (!offset) {
      joint.follows->offset = error;
    } else if (!stands_anywhere && !(std::abs(error) <= kTogether)) {
      const bool angle = turns(*coupled_measure(joint));
      const double unit = angle ? kDegree : 1;
      in.fail_key("offset",
                  fmt::format("where the joints start it is {:.9g}; expected that, or no offset, or "
                              "another \"start\"",
                              (coupling.offset + error) / unit));
    }
  }

  const Node& list_;
  std::size_t first_;
  ModelBuilder& out_;
  std::unordered_map<std::string_view, Index> numbers_;
};

}  // namespace

void read_couplings(const Node& list, std::size_t first, const std::vector<std::size_t>& coupled,
                    ModelBuilder& out) {
  CouplingReader reader(list, first, out);
  for (const std::size_t k : coupled) reader.read(k);
}

}  // namespace pabd
