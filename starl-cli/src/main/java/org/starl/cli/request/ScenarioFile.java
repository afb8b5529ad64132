package org.starl.cli.request;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.apps.Demos;
import org.starl.input.BadInput;
import org.starl.input.DocumentReader;
import org.starl.input.Node;
import org.starl.input.TextFile;

/**
 * A scenario in YAML: {@code app:}, then any settings and parameters, one per line.
 *
 * <pre>
 * app: intersection
 * robots: 8
 * messageLoss: 0.3
 * messageDelay: uniform(10ms,200ms)
 * debris: 2
 * faults: [crash(bot2,at=12s,restart=5s), loss(0.3,until=60s)]
 * </pre>
 *
 * @param file its name; empty if the user named an app instead
 * @param values as text, in the file's order
 * @param lines the line number of each value and of the app
 */
public record ScenarioFile(
    String file, String app, Map<String, String> values, Map<String, Integer> lines) {

  public static final String APP = "app";

  private static final String FAULTS = "faults";
  private static final String EXPECTED =
      "expected a scenario file with lines such as 'app: intersection'";

  public static boolean isScenario(String name) {
    return name.endsWith(".yaml") || name.endsWith(".yml");
  }

  public static ScenarioFile ofApp(String app) {
    return new ScenarioFile("", app, Map.of(), Map.of());
  }

  /** The first words of an error in the value of {@code key}: {@code my.yaml:3: }. */
  String where(String key) {
    return file.isEmpty() ? "" : file + ":" + lines.getOrDefault(key, 1) + ": ";
  }

  /**
   * The request of this file, for an app of {@code demos}.
   *
   * @throws BadInput naming the file's line, the key, the value and the expected form
   */
  public RunRequest.Builder request(Demos demos) {
    String hint = file.isEmpty() ? " (a scenario file's name ends in .yaml)" : "";
    RunRequest.Builder request = RunRequest.Builder.of(demos, app, where(APP), hint);
    values.forEach((key, value) -> request.set(where(key), key, value));
    return request;
  }

  /**
   * @throws BadInput if the file is missing, or is not text, YAML or a scenario
   */
  public static ScenarioFile read(String file) {
    return of(
        file, DocumentReader.read(file, TextFile.read(Path.of(file), EXPECTED), EXPECTED).parts());
  }

  /**
   * The scenario of these parts of a file.
   *
   * @throws BadInput if they are none
   */
  public static ScenarioFile of(String file, Map<String, Node> parts) {
    Map<String, String> values = new LinkedHashMap<>();
    Map<String, Integer> lines = new LinkedHashMap<>();
    parts.forEach((key, node) -> {
      lines.put(key, node.line());
      values.put(key, value(file, key, node));
    });
    String app = values.remove(APP);
    if (app == null) {
      throw new BadInput(file + ": has no 'app:'; " + EXPECTED);
    }
    return new ScenarioFile(file, app, values, lines);
  }

  private static String value(String file, String key, Node node) {
    if (node instanceof Node.Listing list && key.equals(FAULTS)) {
      return faults(file, list);
    }
    if (node instanceof Node.Text text && !text.value().isEmpty()) {
      return text.value();
    }
    String example = key.equals(APP) ? "'app: intersection'" : "'" + key + ": 4'";
    String expected = key.equals(FAULTS) ? "a list of faults" : "one value, such as " + example;
    throw BadInput.at(file, node.line(), key + ": " + node.shown() + ": expected " + expected);
  }

  /** The items joined with commas: YAML splits a list at the commas inside a fault too. */
  private static String faults(String file, Node.Listing list) {
    List<String> parts = new ArrayList<>();
    for (Node item : list.items()) {
      if (!(item instanceof Node.Text text) || text.value().isBlank()) {
        throw BadInput.at(
            file, item.line(), FAULTS + ": " + item.shown() + ": expected a list of faults");
      }
      parts.add(text.value());
    }
    return String.join(",", parts);
  }
}
