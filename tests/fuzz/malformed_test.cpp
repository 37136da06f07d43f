// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Reads every malformed file through the C API, in forked children: no crash, no hang, at most
// 4 x file size + 64 MiB of address space beyond what the child had before, and every failure is
// one line that names the file.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <map>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "jalon/jalon.h"
#include "malformed_files.h"

namespace {

constexpr size_t kBatch = 64;
constexpr size_t kAllowance = size_t{64} << 20;
constexpr unsigned kHang_s =
    300;  // of a file, which takes milliseconds: this ends what would never end

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;  // shadow memory breaks the limit, and all takes longer
#else
constexpr bool kSanitized = false;
#endif

bool is_set(const malformed::File& file) { return file.name == "ept.json"; }

struct Verdict {
  int status = 0, model_status = 0;  // the second: as a model, or of COPC and EPT a box
  double processor_s = 0;
  bool bad_message = false;
};

size_t address_space() {
  size_t pages = 0;
  if (FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%zu", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return pages * static_cast<size_t>(::sysconf(_SC_PAGESIZE));
}

void limit_memory(size_t file_bytes) {
  if (kSanitized) return;
  rlimit limit{};
  ::getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = address_space() + 4 * file_bytes + kAllowance;
  ::setrlimit(RLIMIT_AS, &limit);
}

bool has_boxes(const malformed::File& file) {
  return is_set(file) || file.name.ends_with(".copc.laz");
}

// Of a data set the file that is wrong, which lies beside the index.
bool good_message(std::string path) {
  if (path.ends_with("/ept.json")) path.resize(path.rfind('/'));
  const char* text = jalon_last_error_message();
  return *text != 0 && std::strchr(text, '\n') == nullptr &&
         std::strstr(text, path.c_str()) != nullptr;
}

// Read as clouds these are always unsupported.
bool holds_model(const malformed::File& file) {
  if (is_set(file)) return false;
  for (const char* extension : {".obj", ".stl", ".json", ".dxf"})
    if (file.name.ends_with(extension)) return true;
  return false;
}

void spill(const std::string& path, const std::string& bytes) {
  FILE* out = std::fopen(path.c_str(), "wb");
  if (out == nullptr || std::fwrite(bytes.data(), 1, bytes.size(), out) != bytes.size())
    std::_Exit(90);
  std::fclose(out);
}

// The path to be read.
std::string spill_set(const malformed::File& file, const std::string& folder) {
  const std::string set = folder + "/set/";
  std::filesystem::remove_all(set);
  std::filesystem::create_directories(set);
  spill(set + file.name, file.bytes);
  for (const malformed::Part& part : file.parts) {
    std::filesystem::create_directories(std::filesystem::path(set + part.name).parent_path());
    spill(set + part.name, part.bytes);
  }
  return set + file.name;
}

std::string spill_file(const malformed::File& file, const std::string& folder) {
  if (is_set(file)) return spill_set(file, folder);
  const std::string path = folder + "/" + file.name;
  const std::string beside = path.substr(0, path.rfind('.')) + ".stations.json";
  spill(path, file.bytes);
  if (!file.beside.empty()) spill(beside, file.beside);
  else std::remove(beside.c_str());
  return path;
}

size_t bytes_of(const malformed::File& file) {
  size_t bytes = file.bytes.size() + file.beside.size();
  for (const malformed::Part& part : file.parts) bytes += part.bytes.size();
  return bytes;
}

Verdict judge(const malformed::File& file, const std::string& folder, jalon_task* task) {
  const std::string path = spill_file(file, folder);
  Verdict verdict;
  limit_memory(bytes_of(file));
  const std::clock_t start = std::clock();
  jalon_cloud* cloud = nullptr;
  verdict.status = jalon_cloud_read(path.c_str(), nullptr, task, &cloud);
  verdict.bad_message = (verdict.status != JALON_OK && !good_message(path)) ||
                        (verdict.status == JALON_OK) != (cloud != nullptr);
  jalon_cloud_release(cloud);
  if (has_boxes(file)) {
    cloud = nullptr;
    const double box[6] = {1, -1, 1, 3, 1, 3};
    jalon_params* options = nullptr;
    if (jalon_params_create("read", &options) != JALON_OK ||
        jalon_params_set_doubles(options, "box", box, 6) != JALON_OK)
      std::_Exit(93);
    verdict.model_status = jalon_cloud_read(path.c_str(), options, task, &cloud);
    verdict.bad_message =
        verdict.bad_message || (verdict.model_status != JALON_OK && !good_message(path));
    jalon_cloud_release(cloud);
    jalon_params_release(options);
  }
  if (file.name.ends_with(".ply") || holds_model(file)) {
    jalon_model* model = nullptr;
    verdict.model_status = jalon_model_read(path.c_str(), nullptr, task, &model);
    verdict.bad_message =
        verdict.bad_message || (verdict.model_status != JALON_OK && !good_message(path));
    jalon_model_release(model);
  }
  verdict.processor_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return verdict;
}

// The child writes one verdict a file into the pipe; a file without one took the child down.
void child_main(const std::vector<malformed::File>& files, size_t begin, size_t end,
                const std::string& folder, int pipe) {
  jalon_task* task = nullptr;
  if (jalon_task_create(&task) != JALON_OK || jalon_task_set_threads(task, 1) != JALON_OK)
    std::_Exit(91);
  for (size_t i = begin; i < end; ++i) {
    ::alarm(kHang_s);
    const Verdict verdict = judge(files[i], folder, task);
    if (::write(pipe, &verdict, sizeof verdict) != sizeof verdict) std::_Exit(92);
  }
  std::_Exit(0);
}

class Run {
 public:
  explicit Run(std::string folder) : folder_(std::move(folder)) {}

  bool read_all(const char* format, const std::vector<malformed::File>& files, size_t least) {
    const size_t bad_before = bad_;
    statuses_.clear();
    slowest_s_ = 0;
    for (size_t begin = 0; begin < files.size();) begin = batch(files, begin);
    std::printf("%-5s %zu malformed files, %zu bad;", format, files.size(), bad_ - bad_before);
    for (const auto& [status, count] : statuses_) std::printf(" status %d: %zu", status, count);
    std::printf("\nFIGURE %s: the slowest file took %.3f s of processor\n", format, slowest_s_);
    if (files.size() < least) std::printf("%s: fewer than the %zu files wanted\n", format, least);
    return bad_ == bad_before && files.size() >= least;
  }

 private:
  size_t batch(const std::vector<malformed::File>& files, size_t begin) {
    const size_t end = std::min(files.size(), begin + kBatch);
    int ends[2];
    if (::pipe(ends) != 0) std::abort();
    const pid_t child = ::fork();
    if (child == 0) child_main(files, begin, end, folder_, ends[1]);
    ::close(ends[1]);
    size_t at = begin;
    for (Verdict verdict; ::read(ends[0], &verdict, sizeof verdict) == sizeof verdict; ++at)
      note(files[at], at, verdict);
    ::close(ends[0]);
    int state = 0;
    ::waitpid(child, &state, 0);
    if (at == end && state == 0) return end;
    ++bad_;
    std::printf("file %zu (%s): the reader died, state %d\n", at,
                at < files.size() ? files[at].name.c_str() : "", state);
    return at + 1;
  }

  void note(const malformed::File& file, size_t index, const Verdict& verdict) {
    ++statuses_[holds_model(file) || has_boxes(file) ? verdict.model_status : verdict.status];
    slowest_s_ = std::max(slowest_s_, verdict.processor_s);
    const auto allowed = [&file](int status) {
      if (is_set(file) && (status == JALON_ERROR_NOT_FOUND || status == JALON_ERROR_IO))
        return true;
      return status == JALON_OK || status == JALON_ERROR_FORMAT ||
             status == JALON_ERROR_UNSUPPORTED || status == JALON_ERROR_LIMIT;
    };
    if (allowed(verdict.status) && allowed(verdict.model_status) && !verdict.bad_message) return;
    ++bad_;
    std::printf("file %zu (%s): status %d, model %d%s\n", index, file.name.c_str(), verdict.status,
                verdict.model_status, verdict.bad_message ? ", bad message" : "");
  }

  std::string folder_;
  std::map<int, size_t> statuses_;
  double slowest_s_ = 0;
  size_t bad_ = 0;
};

}  // namespace

int main() {
  std::string folder = "/tmp/jalon-malformed-XXXXXX";
  if (const char* temporary = std::getenv("TMPDIR"))
    folder = std::string(temporary) + "/jalon-malformed-XXXXXX";
  if (::mkdtemp(folder.data()) == nullptr) return 1;
  Run run(folder);
  const bool good[] = {run.read_all("LAS", malformed::las_files(), 400),
                       run.read_all("PLY", malformed::ply_files(), 400),
                       run.read_all("text", malformed::text_files(), 100),
                       run.read_all("OBJ", malformed::obj_files(), 100),
                       run.read_all("noted", malformed::noted_obj_files(), 100),
                       run.read_all("STL", malformed::stl_files(), 300),
                       run.read_all("city", malformed::city_files(), 400),
                       run.read_all("DXF", malformed::dxf_files(), 300),
                       run.read_all("PTX", malformed::ptx_files(), 300),
                       run.read_all("PTS", malformed::pts_files(), 100),
                       run.read_all("PCD", malformed::pcd_files(), 300),
                       run.read_all("EPT", malformed::ept_sets(), 500),
                       run.read_all("of stations", malformed::station_files(), 1000)};
  size_t skipped = 0, failed_of_others = 0, passed_of_others = 0;
  for (const auto& [format, files] :
       {std::pair{"LAZ", malformed::laz_files()}, std::pair{"E57", malformed::e57_files()},
        std::pair{"COPC", malformed::copc_files()}, std::pair{"PNG", malformed::png_files()}}) {
    if (files.empty()) std::printf("%s: skipped: no shared data, or not built\n", format);
    if (files.empty()) ++skipped;
    else ++(run.read_all(format, files, 300) ? passed_of_others : failed_of_others);
  }
  const std::string clean = "rm -rf '" + folder + "'";
  if (std::system(clean.c_str()) != 0) std::printf("%s stays behind\n", folder.c_str());
  size_t passed = passed_of_others;
  for (const bool one : good) passed += one ? 1 : 0;
  const size_t failed = std::size(good) + passed_of_others + failed_of_others - passed;
  std::printf("%zu passed, %zu failed, %zu skipped\n", passed, failed, skipped);
  return failed == 0 ? 0 : 1;
}
