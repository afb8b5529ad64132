package org.starl.cli.schema;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.apps.Demo;
import org.starl.apps.Demos;
import org.starl.cli.request.RunRequest;
import org.starl.cli.request.ScenarioFile;
import org.starl.robot.file.DeploymentFormat;
import org.starl.sim.Setting;

/**
 * The JSON schema of deployment files, for editors, made from the {@link DeploymentFormat} that
 * reads them. It accepts the files that {@code deploy check} accepts, except values with needless
 * quotes. It does not check conditions between two values or on the machine.
 */
final class DeploymentSchema {

  private DeploymentSchema() {}

  static Map<String, Object> json(Demos demos) {
    Map<String, Object> schema =
        JsonSchema.document(
            "StarL deployment", "A file for 'starl deploy': an app on real robots.");
    List<String> settings = RunRequest.known().stream().map(Setting::key).toList();
    schema.put("definitions", Map.of("setting", Map.of("enum", settings)));
    schema.putAll(JsonSchema.mapping(DeploymentFormat.FILE.fields()));
    Map<String, Object> properties = JsonSchema.properties(DeploymentFormat.FILE.fields());
    properties.put(ScenarioFile.APP, ScenarioSchema.apps(demos));
    schema.put(JsonSchema.PROPERTIES, properties);
    schema.put("allOf", demos.all().stream().map(DeploymentSchema::parameters).toList());
    return schema;
  }

  /** If the file has this app: its parameters, and no others. */
  private static Map<String, Object> parameters(Demo demo) {
    Map<String, Object> rule = new LinkedHashMap<>(ScenarioSchema.parameters(demo, Map.of()));
    rule.computeIfPresent(
        "then", (key, then) -> Map.of(JsonSchema.PROPERTIES, Map.of("parameters", then)));
    return rule;
  }
}
