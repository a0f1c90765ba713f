/// \file
/// rayproof merge: what one campaign would have written, from its shards.

#include "command_line/command_line.hpp"
#include "programs/check/campaign.hpp"

namespace {

using namespace rayproof;

int run(const std::vector<std::string>& files, const check::Options& options) {
  std::vector<campaign::CampaignState> shards;
  for (const std::string& file : files)
    shards.push_back(campaign::load(std::filesystem::is_directory(file) ? file + "/campaign.json" : file));
  const campaign::CampaignState whole = campaign::merged(shards);
  std::filesystem::create_directories(options.out);
  campaign::save(whole, check::state_file(options));
  return check::report_campaign(whole, options);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Puts the shards of a campaign together to what one run would have written.",
               "rayproof merge");
  check::Options options;
  std::vector<std::string> files;
  app.add_option("SHARDS", files, "The folders of the shards, or their campaign.json")->required();
  app.add_option("--out", options.out, "Folder for the merged campaign")->required()->type_name("DIR");
  app.footer(
      "Exit status: as of rayproof check; 2 also where a shard is missing, given twice, unfinished, or of "
      "another "
      "campaign.");
  if (const auto status = parse_command_line(app, argc, argv)) return *status;
  try {
    return run(files, options);
  } catch (const std::runtime_error& trouble) {
    fmt::print(stderr, "rayproof merge: {}\n", trouble.what());
  }
  return 2;
}
