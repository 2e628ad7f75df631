// SPDX-License-Identifier: Apache-2.0
// image-analogy: a picture filtered as another was filtered.
#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>

#include "cli/image_analogy/settings.h"
#include "converters/common/command.h"
#include "converters/common/files.h"
#include "converters/image/image_file.h"
#include "converters/image/source_map_file.h"
#include "libstyle/image/image_analogy.h"

namespace libstyle {
namespace {

// The pictures of a run, and how finely the result should tell samples apart.
struct Pictures {
  ImageAnalogyInput input;
  SampleDepth depth = SampleDepth::k8;
};

// Checks what files there are before any is read.
void check_usage(const ImageAnalogySettings& settings) {
  if (settings.filtered.empty()) {
    throw UsageError("--filtered is missing: the example, a picture in the style");
  }
  if (settings.unfiltered.size() > settings.filtered.size() ||
      (!settings.unfiltered.empty() && settings.unfiltered.size() < settings.filtered.size())) {
    throw UsageError("each --filtered has its --unfiltered, in the same order, or none has");
  }
  const bool makes_texture = settings.unfiltered.empty() && settings.target.empty();
  if (!settings.apply_map.empty()) {
    if (!makes_texture || !settings.guides.empty()) {
      throw UsageError("--apply-map takes --filtered alone: the pictures that are copied from");
    }
    return;
  }
  if (settings.size.empty() == (makes_texture && settings.guides.empty())) {
    throw UsageError(settings.size.empty()
                         ? "give --unfiltered and --target to filter a picture, or --size for a "
                           "texture of that size"
                         : "--size is for textures; the target decides the size of the result");
  }
  if (!settings.target.empty() && settings.unfiltered.empty() &&
      settings.application != "transfer") {
    throw UsageError("--unfiltered is missing: without it nothing says how the target is filtered");
  }
}

void write(const std::string& name, const std::string& bytes) {
  OutputFile file(name);
  file.write(bytes);
  file.commit();
}

ImageGuide read_guide(const std::string& text) {
  const GuideFiles files = parse_guide(text);
  ImageGuide guide;
  guide.weight = files.weight;
  for (const std::string& name : files.examples) guide.examples.push_back(read_image(name).image);
  guide.target = read_image(files.target).image;
  return guide;
}

Pictures read_pictures(const ImageAnalogySettings& settings) {
  Pictures pictures;
  ImageAnalogyInput& input = pictures.input;
  for (std::size_t i = 0; i < settings.filtered.size(); ++i) {
    ImageFile filtered = read_image(settings.filtered[i]);
    pictures.depth = std::max(pictures.depth, filtered.depth);
    ImagePair pair;
    if (!settings.unfiltered.empty()) pair.unfiltered = read_image(settings.unfiltered[i]).image;
    if (settings.unfiltered.empty() && settings.application == "transfer") {
      pair.unfiltered = filtered.image;
    }
    pair.filtered = std::move(filtered.image);
    input.examples.push_back(std::move(pair));
  }
  if (!input.examples.front().unfiltered.empty()) {
    ImageFile target = read_image(settings.target.empty() ? "-" : settings.target);
    pictures.depth = std::max(pictures.depth, target.depth);
    input.target = std::move(target.image);
  }
  for (const std::string& guide : settings.guides) input.guides.push_back(read_guide(guide));
  if (!settings.size.empty()) std::tie(input.width, input.height) = parse_size(settings.size);
  return pictures;
}

void note_levels(const ImageAnalogyResult& result, Session& session) {
  for (const LevelReport& level : result.levels) {
    JsonObject item;
    item.count("width", static_cast<std::uint64_t>(level.width))
        .count("height", static_cast<std::uint64_t>(level.height))
        .number("coherent_share", level.coherent_share)
        .number("seconds", level.seconds);
    session.note("levels", item);
  }
}

// Other pictures of the examples' sizes, such as normals, put together like an earlier result.
void apply_map(const ImageAnalogySettings& settings) {
  const ImageFormat format = output_format(settings);
  const SourceMap map = read_source_map(settings.apply_map);
  std::vector<Image> examples;
  SampleDepth depth = SampleDepth::k8;
  for (const std::string& name : settings.filtered) {
    ImageFile file = read_image(name);
    depth = std::max(depth, file.depth);
    examples.push_back(std::move(file.image));
  }
  const Image result = at_place({display_name(settings.apply_map)}, [&] {
    return copy_from_sources(examples, map.pixels, map.width, map.height);
  });
  write(settings.output, encode_image(result, format, output_depth(settings, depth)));
}

void filter(const ImageAnalogySettings& settings, Session& session) {
  const ImageFormat format = output_format(settings);
  const ImageAnalogyParameters parameters = image_analogy_parameters(settings);
  const Pictures pictures = read_pictures(settings);
  const ImageAnalogyResult result =
      make_image_analogy(pictures.input, parameters, session.progress_handler());
  note_levels(result, session);
  const std::string bytes =
      encode_image(result.filtered, format, output_depth(settings, pictures.depth));
  if (!settings.source_map.empty()) {
    write(settings.source_map,
          encode_source_map({result.filtered.width, result.filtered.height, result.sources}));
  }
  write(settings.output, bytes);
}

void run(const ImageAnalogySettings& settings, Session& session) {
  check_usage(settings);
  settings.apply_map.empty() ? filter(settings, session) : apply_map(settings);
}

std::vector<Option> options(ImageAnalogySettings& settings) {
  std::vector<Option> result = {
      {"--unfiltered", "FILE", "the example before it was filtered; with another --filtered, again",
       &settings.unfiltered, HistoryUse::kFile},
      {"--filtered", "FILE", "the example: a picture in the style", &settings.filtered,
       HistoryUse::kFile},
      {"--target", "FILE", "the picture to filter; without it, stdin", &settings.target,
       HistoryUse::kFile},
      {"--guide", "FILES",
       "what else says what belongs where: EXAMPLE[,EXAMPLE...]:TARGET[*WEIGHT]", &settings.guides,
       HistoryUse::kFile},
      {"--size", "WIDTHxHEIGHT", "make a texture of this size from --filtered alone",
       &settings.size}};
  for (Option& option : match_options(settings)) result.push_back(std::move(option));
  for (Option& option : std::vector<Option>{
           {"--source-map", "FILE", "write where each pixel was copied from, as a PNG",
            &settings.source_map, HistoryUse::kLeftOut},
           {"--apply-map", "FILE", "copy --filtered by a map that --source-map wrote, and end",
            &settings.apply_map, HistoryUse::kFile},
           threads_option(settings.parameters.threads),
           {"--output,-o", "FILE", "write here rather than to stdout", &settings.output,
            HistoryUse::kLeftOut},
           {"--format",
            "FORMAT",
            "what to write when the name of the output does not say it",
            &settings.format,
            HistoryUse::kRecorded,
            {"png", "jpg", "tif", "ppm", "exr"}},
           {"--depth",
            "BITS",
            "of a sample of the output, when not those of the pictures",
            &settings.depth,
            HistoryUse::kRecorded,
            {"8", "16", "float"}}}) {
    result.push_back(std::move(option));
  }
  return result;
}

Command describe(ImageAnalogySettings& settings) {
  return {.name = "image-analogy",
          .summary = "filter a picture as an example was filtered",
          .synopsis =
              {"image-analogy --unfiltered photo.png --filtered painting.png --for painting "
               "--target cat.png -o painted-cat.png",
               "image-analogy --filtered gravel.png --size 1024x1024 -o path.png",
               "image-analogy --unfiltered labels.png --filtered photo.png --for numbers "
               "--target new-labels.png -o new-photo.png",
               "image-analogy --filtered weave.png --for transfer --target face.png > woven.png",
               "image-analogy --filtered gravel.png --size 1024x1024 --source-map map.png "
               "-o path.png",
               "image-analogy --filtered gravel-normals.png --apply-map map.png -o "
               "path-normals.png"},
          .options = options(settings),
          .run = [&settings](Session& session) { run(settings, session); },
          .has_report = true,
          .given = &settings.given};
}

}  // namespace
}  // namespace libstyle

int main(int argc, char** argv) {
  libstyle::ImageAnalogySettings settings;
  return libstyle::run_command(argc, argv, libstyle::describe(settings));
}
