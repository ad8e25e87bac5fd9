// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/result_head.hpp"
#include "verification/judge/first_cases.hpp"
#include "verification/judge/judgement_text.hpp"

namespace ehd::judging {

namespace {

Json score_json(const Score& score) {
  const Certified& certified = score.certified;
  Json known{{"digits", certified.digits}, {"scaling", to_string(certified.scaling)}};
  put(known, "hertz", certified.value);
  put(known, "uncertainty", certified.uncertainty);
  known["kind"] = to_string(certified.kind);
  Json json{{"quantity", to_string(certified.quantity)}, {"certified", known}};
  put(json, "digits", score.digits);
  json["missing"] = score.missing();
  put(json, "hertz", score.value);
  put(json, "error", score.error);
  put(json, "stated_error", score.stated_error);
  if (score.honesty) json["honesty"] = to_string(*score.honesty);
  return json;
}

Json profile_json(const JudgedProfile& profile) {
  Json json{{"file", profile.file}, {"gates", Json::array()}};
  for (const Gate& gate : profile.gates) {
    Json one{{"name", gate.name}, {"quadrature", gate.quadrature}, {"verdict", to_string(gate.verdict)}};
    put(one, "error", gate.error);
    put(one, "uncertainty", gate.uncertainty);
    put(one, "tolerance", gate.tolerance.value());
    one["reason"] = gate.tolerance.reason();
    json["gates"].push_back(one);
  }
  put(json, "pressure_error", profile.pressure_error);
  if (profile.pressure_error) json["truth"] = profile.truth;
  return json;
}

Json case_json(const JudgedCase& judged) {
  Json json{{"case", judged.id}, {"version", judged.version}, {"title", judged.title}};
  json["submitted"] = judged.submitted;
  const auto* const first =
      std::find_if(first_cases.begin(), first_cases.end(), [&](const FirstCase& one) { return one.id == judged.id; });
  if (first != first_cases.end()) {
    json["place"] = first - first_cases.begin() + 1;
    json["tests"] = first->tests;
  }
  if (judged.groups) {
    const Regime regime = regime_of(*judged.groups);
    put(json, "M", judged.groups->M);
    put(json, "L", judged.groups->L);
    json["regime"] = {{"load", to_string(regime.load)}, {"material", to_string(regime.material)}};
  }
  json["scores"] = Json::array();
  for (const Score& score : judged.scores) json["scores"].push_back(score_json(score));
  json["not_certified"] = judged.not_certified;
  if (judged.profile) json["profile"] = profile_json(*judged.profile);
  put(json, "wall_s", judged.wall_s);
  json["hints"] = judged.hints;
  return json;
}

}  // namespace

Json to_json(const Judgement& judgement) {
  Json json = result_head(judgement_schema);
  const Submission& from = judgement.submission;
  json["submission"] = from.file.filename().string();
  json["solver"]["name"] = from.name;
  if (!from.version.empty()) json["solver"]["version"] = from.version;
  if (!from.url.empty()) json["solver"]["url"] = from.url;
  if (!from.hardware.empty()) json["hardware"] = from.hardware;
  json["cases"] = Json::array();
  for (const JudgedCase& one : judgement.cases) json["cases"].push_back(case_json(one));
  json["regimes"] = Json::array();
  for (const RegimeDigits& row : judgement.regimes) {
    Json one{{"load", to_string(row.regime.load)},
             {"material", to_string(row.regime.material)},
             {"numbers", row.numbers},
             {"missing", row.missing}};
    put(one, "median", row.median);
    put(one, "worst", row.worst);
    put(one, "median_given", row.median_given);
    json["regimes"].push_back(one);
  }
  json["honesty"] = {{"met", judgement.met}, {"missed", judgement.missed}, {"undecided", judgement.undecided}};
  json["gates_hold"] = judgement.gates_hold();
  return json;
}

}  // namespace ehd::judging
