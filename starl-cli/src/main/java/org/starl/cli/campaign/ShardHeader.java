package org.starl.cli.campaign;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.type.TypeReference;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.Version;
import org.starl.apps.Demos;
import org.starl.cli.command.Digest;
import org.starl.cli.command.Json;
import org.starl.cli.report.RowJson;
import org.starl.cli.request.RunRequest;
import org.starl.cli.request.Seeds;
import org.starl.input.BadInput;
import org.starl.sim.explore.Exploration;

/**
 * The first line of a shard's file: the work, and its part.
 *
 * @param work all that shards of one work have in common, by name
 * @param part the shard, as text
 * @param command that of the whole work, as the user typed it
 */
record ShardHeader(Map<String, Object> work, String part, String command) {

  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final TypeReference<LinkedHashMap<String, Object>> OBJECT =
      new TypeReference<>() {};

  static ShardHeader of(ShardWork<?> work, Shard shard, String command) {
    Map<String, Object> all =
        Json.object("format", format(work.command()), "starl", Version.STARL, "app", work.app());
    all.putAll(work.fields());
    return new ShardHeader(parsed(Json.line(all)), shard.toString(), command);
  }

  private static String format(String command) {
    return "starl-" + command + " 1";
  }

  /**
   * A digest of what decides a run: the version, the app and its settings.
   *
   * @param more that decides
   */
  static String key(RunRequest request, Map<String, Object> more) {
    Map<String, Object> deciding =
        Json.object(
            "starl", Version.STARL, "app", request.demo().name(), "settings", settings(request));
    deciding.putAll(more);
    return Digest.of(Json.line(deciding), List.of());
  }

  /** The given parameters of the app and the given settings. */
  static SortedMap<String, String> settings(RunRequest request) {
    SortedMap<String, String> settings = new TreeMap<>(request.parameters());
    request.settings().given().forEach((setting, value) -> settings.put(setting.key(), value));
    return settings;
  }

  /** As JSON on one line. */
  String line() {
    Map<String, Object> all = new LinkedHashMap<>(work);
    all.put("shard", part);
    all.put("command", command);
    return Json.line(all);
  }

  private static Map<String, Object> parsed(String line) {
    try {
      return MAPPER.readValue(line, OBJECT);
    } catch (JsonProcessingException e) {
      return Map.of();
    }
  }

  /**
   * The header in a file's first line.
   *
   * @throws BadInput if it is none, or of another version
   */
  static ShardHeader read(String file, String line) {
    String where = file + ":1: ";
    Map<String, Object> all = new LinkedHashMap<>(parsed(line));
    List<String> formats = new ArrayList<>();
    ShardOptions.COMMANDS.forEach(command -> formats.add(format(command)));
    if (!formats.contains(text(all, "format"))) {
      throw new BadInput(
          where
              + BadInput.quote(line)
              + ": expected a file of 'starl campaign --out', or of sweep or explore");
    }
    String starl = text(all, "starl");
    if (!starl.equals(Version.STARL)) {
      throw new BadInput(
          "%swas written by StarL %s; expected this version, %s"
              .formatted(where, BadInput.quote(starl), Version.STARL));
    }
    String shard = String.valueOf(all.remove("shard"));
    String command = String.valueOf(all.remove("command"));
    return new ShardHeader(all, shard, command);
  }

  private static String text(Map<String, Object> all, String name) {
    return String.valueOf(all.get(name));
  }

  /**
   * The part, of {@code work}.
   *
   * @throws BadInput if there is no such part
   */
  Shard shard(String file, ShardWork<?> of) {
    return Shard.of(file + ":1: shard", part, of);
  }

  /**
   * Checks that both are of one work.
   *
   * @throws BadInput with the first difference
   */
  void requireSameWork(String file, ShardHeader expected) {
    expected.work.forEach((name, value) -> {
      if (!value.equals(work.get(name))) {
        throw new BadInput(
            "%s:1: %s: %s: expected %s, as in the other shards"
                .formatted(file, name, work.get(name), value));
      }
    });
  }

  /**
   * The work of which this is a part.
   *
   * @throws BadInput if {@code demos} do not have its app, or a value is unknown
   */
  ShardWork<?> work(String file, Demos demos) {
    try {
      String format = text(work, "format");
      if (format.equals(format("sweep"))) {
        SweepFile sweep = SweepFile.of(text(work, "file"), text(work, "text"));
        return SeedWork.sweep(sweep, demos);
      }
      RunRequest request = request(demos);
      if (format.equals(format("explore"))) {
        Exploration exploration =
            RowJson.record(work.getOrDefault("exploration", ""), Exploration.class);
        return new ExploreWork(request, Seeds.of(text(work, "seed")), exploration);
      }
      Seeds.Range seeds = Seeds.Range.of(text(work, "seeds"));
      boolean stops = Boolean.parseBoolean(text(work, "stop"));
      return SeedWork.campaign(request, seeds, Ending.of(stops, text(work, "until"), seeds));
    } catch (BadInput e) {
      throw new BadInput(file + ":1: " + e.getMessage());
    }
  }

  private RunRequest request(Demos demos) {
    RunRequest.Builder request = RunRequest.Builder.of(demos, text(work, "app"), "", "");
    if (work.get("settings") instanceof Map<?, ?> settings) {
      settings.forEach((key, value) -> request.set("", key.toString(), value.toString()));
    }
    return request.build();
  }
}
