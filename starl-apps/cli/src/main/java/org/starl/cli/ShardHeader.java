package org.starl.cli;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.Version;
import org.starl.apps.Demos;
import org.starl.input.BadInput;

/**
 * The first line of a shard's file: the campaign, and its part.
 *
 * @param starl the version that wrote it
 * @param settings the parameters of the app, and the given settings
 * @param command the campaign's, as the user typed it
 */
record ShardHeader(
    String starl,
    String app,
    SortedMap<String, String> settings,
    Seeds.Range range,
    Shard shard,
    Ending ending,
    String command) {

  private static final String FORMAT = "starl-campaign 1";
  private static final int KEY_BYTES = 8;
  private static final ObjectMapper MAPPER = new ObjectMapper();

  static ShardHeader of(
      RunRequest request, Seeds.Range range, Shard shard, Ending ending, String command) {
    return new ShardHeader(
        Version.STARL, request.demo().name(), settings(request), range, shard, ending, command);
  }

  /** A digest of what decides the run of a seed: the version, the app and its settings. */
  static String key(RunRequest request) {
    Map<String, Object> deciding =
        Json.object(
            "starl", Version.STARL, "app", request.demo().name(), "settings", settings(request));
    try {
      byte[] text = Json.line(deciding).getBytes(StandardCharsets.UTF_8);
      byte[] digest = MessageDigest.getInstance("SHA-256").digest(text);
      return HexFormat.of().formatHex(digest, 0, KEY_BYTES);
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException(e);
    }
  }

  private static SortedMap<String, String> settings(RunRequest request) {
    SortedMap<String, String> settings = new TreeMap<>(request.parameters());
    request.settings().given().forEach((setting, value) -> settings.put(setting.key(), value));
    return settings;
  }

  /** What shards of one campaign have in common, by name. */
  private Map<String, Object> campaign() {
    Map<String, Object> campaign = new LinkedHashMap<>();
    campaign.put("format", FORMAT);
    campaign.put("starl", starl);
    campaign.put("app", app);
    campaign.put("settings", settings);
    campaign.put("seeds", range.toString());
    campaign.put("stop", ending.stops());
    campaign.put("until", ending.untilText());
    return campaign;
  }

  /** As JSON on one line. */
  String line() {
    Map<String, Object> all = campaign();
    all.put("shard", shard.toString());
    all.put("command", command);
    return Json.line(all);
  }

  /**
   * The header in a file's first line.
   *
   * @throws BadInput if it is none, or of another version
   */
  static ShardHeader read(String file, String line) {
    String where = file + ":1: ";
    JsonNode json;
    try {
      json = MAPPER.readTree(line);
    } catch (JsonProcessingException e) {
      throw notAShard(where, line);
    }
    if (!json.path("format").asText().equals(FORMAT)) {
      throw notAShard(where, line);
    }
    String starl = json.path("starl").asText();
    if (!starl.equals(Version.STARL)) {
      throw new BadInput(
          "%swas written by StarL %s; expected this version, %s"
              .formatted(where, BadInput.quote(starl), Version.STARL));
    }
    SortedMap<String, String> settings = new TreeMap<>();
    json.path("settings")
        .properties()
        .forEach(entry -> settings.put(entry.getKey(), entry.getValue().asText()));
    try {
      Seeds.Range range = Seeds.Range.of(json.path("seeds").asText());
      return new ShardHeader(
          starl,
          json.path("app").asText(),
          settings,
          range,
          Shard.of("shard", json.path("shard").asText(), range),
          Ending.of(json.path("stop").asBoolean(), json.path("until").asText(), range),
          json.path("command").asText());
    } catch (BadInput e) {
      throw new BadInput(where + e.getMessage());
    }
  }

  private static BadInput notAShard(String where, String line) {
    return new BadInput(
        where + BadInput.quote(line) + ": expected a file of 'starl campaign --out'");
  }

  /**
   * Checks that both are of one campaign.
   *
   * @throws BadInput with the first difference
   */
  void requireSameCampaign(String file, ShardHeader expected) {
    Map<String, Object> mine = campaign();
    expected
        .campaign()
        .forEach((name, value) -> {
          if (!value.equals(mine.get(name))) {
            throw new BadInput(
                "%s:1: %s: %s: expected %s, as in the same campaign"
                    .formatted(file, name, mine.get(name), value));
          }
        });
  }

  /**
   * The request that this campaign runs.
   *
   * @throws BadInput if {@code demos} do not have its app, or a setting is unknown
   */
  RunRequest request(String file, Demos demos) {
    String where = file + ":1: ";
    RunRequest.Builder request = RunRequest.Builder.of(demos, app, where, "");
    settings.forEach((key, value) -> request.set(where, key, value));
    return request.build();
  }
}
