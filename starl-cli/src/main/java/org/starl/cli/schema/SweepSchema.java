package org.starl.cli.schema;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.apps.Demo;
import org.starl.apps.Demos;
import org.starl.cli.campaign.SweepFile;
import org.starl.cli.campaign.SweptKey;
import org.starl.cli.command.Json;
import org.starl.cli.request.ScenarioFile;

/**
 * The JSON schema of {@link SweepFile}, for editors: that of scenarios, with seeds, the settings and
 * parameters to vary, and the measures to show. Names of measures are not checked.
 */
final class SweepSchema {

  private static final String SWEEP = "sweep";
  private static final String RANGE =
      "^\\s*"
          + SweptKey.NUMBER
          + "[A-Za-z/%]* *\\.\\. *"
          + SweptKey.NUMBER
          + "[A-Za-z/%]*( +in +\\d{1,4})?\\s*$";

  private SweepSchema() {}

  static Map<String, Object> json(Demos demos) {
    Map<String, Object> own = new LinkedHashMap<>();
    own.put(
        "seeds",
        Json.object(
            JsonSchema.DESCRIPTION,
            "the seeds of each point",
            "type",
            List.of("string", "integer"),
            "pattern",
            "^\\s*\\d{1,10}(\\.\\.\\d{1,10})?\\s*$",
            "minimum",
            0));
    own.put(
        SWEEP,
        Json.object(
            "type",
            "object",
            "minProperties",
            1,
            JsonSchema.PROPERTIES,
            swept(ScenarioSchema.settings())));
    own.put(
        "samples",
        Json.object(
            JsonSchema.DESCRIPTION,
            "points of a Latin hypercube, instead of all combinations",
            "type",
            "integer",
            "minimum",
            1,
            "maximum",
            SweepFile.MOST_POINTS));
    own.put(
        "sampleSeed",
        Json.object(
            JsonSchema.DESCRIPTION, "another number draws other points", "type", "integer"));
    Map<String, Object> listed = Json.object("type", "array", "items", Map.of("type", "string"));
    own.put(
        "show",
        Json.object(
            JsonSchema.DESCRIPTION,
            "the measures of the table and the page",
            "anyOf",
            List.of(Map.of("type", "string"), listed)));
    List<String> names = new ArrayList<>(own.keySet());
    names.add(ScenarioFile.APP);
    return ScenarioSchema.json(
        "StarL sweep",
        "A file for 'starl sweep FILE.yaml': a scenario, and settings and parameters to vary.",
        demos,
        own,
        List.of("seeds", SWEEP),
        demo -> rule(demo, names));
  }

  /** What a sweep of this app may vary: settings and the app's parameters. */
  private static Map<String, Object> rule(Demo demo, List<String> own) {
    Map<String, Object> parameters = swept(ScenarioSchema.parametersOf(demo));
    Object isSetting =
        Map.of(
            "allOf",
            List.of(Map.of("$ref", "#/definitions/setting"), Map.of("not", Map.of("enum", own))));
    Object isParameter = Map.of("enum", List.copyOf(parameters.keySet()));
    Object name =
        parameters.isEmpty() ? isSetting : Map.of("anyOf", List.of(isSetting, isParameter));
    return Map.of(SWEEP, Json.object(JsonSchema.PROPERTIES, parameters, "propertyNames", name));
  }

  private static Map<String, Object> swept(Map<String, Object> properties) {
    Map<String, Object> swept = new LinkedHashMap<>();
    properties.forEach((key, value) -> swept.put(key, values(value)));
    return swept;
  }

  /** A list of such values, or a range. */
  private static Map<String, Object> values(Object value) {
    Map<String, Object> list = Json.object("type", "array", "minItems", 1, "items", value);
    Map<String, Object> range = Json.object("type", "string", "pattern", RANGE);
    return Map.of("anyOf", List.of(list, range));
  }
}
