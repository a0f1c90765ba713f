/// \file
/// rayproof merge: what one campaign would have written, from its shards.

#include "case/files.hpp"
#include "command_line/command_line.hpp"
#include "programs/check/campaign.hpp"
#include "programs/check/folder_lock.hpp"

namespace {

using namespace rayproof;

int run(const std::vector<std::string>& files, const check::Options& options) {
  std::vector<campaign::CampaignState> shards;
  for (const std::string& file : files)
    shards.push_back(campaign::load(std::filesystem::is_directory(file) ? file + "/campaign.json" : file));
  const campaign::CampaignState whole = campaign::merged(shards);
  make_folder(options.out);
  const check::FolderLock lock(options.out);
  const std::string out = check::state_file(options);
  if (std::filesystem::exists(out)) {
    std::ifstream before = opened_to_read(out);
    if (whole_text(before, out) != campaign::write_state(whole))
      throw std::runtime_error(out + " holds another campaign, or a shard: --out names another folder");
  }
  campaign::save(whole, out);
  return check::report_campaign(whole, options);
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine app("Puts the shards of a campaign together to what one run would have written.",
                  "rayproof merge");
  check::Options options;
  std::vector<std::string> files;
  app.add_option("SHARDS", files, "The folders of the shards, or their campaign.json")->required();
  app.add_option("--out", options.out, "Folder for the merged campaign")->required()->type_name("DIR");
  app.footer(
      "SHARDS are what rayproof check --campaign --shard I/N --out DIR wrote, all N of them, in any order; "
      "they\n"
      "are read and never changed. DIR gets campaign.json, findings.jsonl and index.html, byte for byte as "
      "one\n"
      "run without --shard would have written them. docs/campaigns.md has examples.\n"
      "Exit status: as of rayproof check: 0 every contract holds; 1 not so; 2 wrong command line, or a shard "
      "that\n"
      "is missing, given twice, unfinished, damaged or of another campaign, or a DIR that holds something "
      "else.");
  if (const auto status = parse_command_line(app, argc, argv)) return *status;
  try {
    return run(files, options);
  } catch (const std::exception& trouble) {
    print_trouble("rayproof merge", trouble);
  }
  return 2;
}
