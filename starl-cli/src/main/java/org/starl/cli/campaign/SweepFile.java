package org.starl.cli.campaign;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Demos;
import org.starl.cli.request.RunRequest;
import org.starl.cli.request.ScenarioFile;
import org.starl.cli.request.Seeds;
import org.starl.input.BadInput;
import org.starl.input.DocumentReader;
import org.starl.input.Node;
import org.starl.input.Quantities;
import org.starl.input.TextFile;
import org.starl.random.Rng;

/**
 * A sweep in YAML: a scenario, and the settings and parameters to vary.
 *
 * <pre>
 * app: intersection
 * duration: 5min
 * seeds: 1..20
 * sweep:
 *   arrivals: 4/min..20/min in 5
 *   messageLoss: [0, 0.2]
 * show: [crossed_per_min, wait_p95_s]
 * </pre>
 *
 * @param samples number of points of a Latin hypercube; 0 for a grid
 * @param sampleSeed of the samples
 * @param show the measures of the table and the report; may be empty
 * @param showLine its line
 * @param text of the file
 */
public record SweepFile(
    ScenarioFile scenario,
    Seeds.Range seeds,
    List<SweptKey> swept,
    int samples,
    long sampleSeed,
    List<String> show,
    int showLine,
    String text) {

  public static final int MOST_POINTS = 10_000;
  private static final int MOST_RUNS = 1_000_000;

  private static final String EXPECTED =
      "expected a sweep with lines such as 'app: intersection', 'seeds: 1..20' and 'sweep:'";

  /**
   * @throws BadInput if the file is missing, or is not text, YAML or a sweep
   */
  static SweepFile read(String file) {
    return of(file, TextFile.read(Path.of(file), EXPECTED));
  }

  /**
   * The sweep in a file's text.
   *
   * @throws BadInput if it is not YAML or a sweep
   */
  public static SweepFile of(String file, String text) {
    Map<String, Node> parts =
        new LinkedHashMap<>(DocumentReader.read(file, text, EXPECTED).parts());
    Node sweep = parts.remove("sweep");
    if (!(sweep instanceof Node.Mapping mapping) || mapping.parts().isEmpty()) {
      throw BadInput.at(
          file,
          sweep == null ? 1 : sweep.line(),
          "sweep: expected settings with their values, such as 'messageLoss: [0, 0.1, 0.3]'");
    }
    List<SweptKey> swept = new ArrayList<>();
    mapping
        .parts()
        .forEach((key, node) -> {
          if (parts.containsKey(key) || key.equals(ScenarioFile.APP)) {
            throw BadInput.at(
                file, node.line(), key + ": expected it either fixed or under 'sweep:'");
          }
          swept.add(SweptKey.of(file, key, node));
        });
    Seeds.Range seeds = seeds(file, parts.remove("seeds"));
    int samples = (int) whole(file, "samples", parts.remove("samples"), 0, 1, MOST_POINTS);
    long sampleSeed =
        whole(file, "sampleSeed", parts.remove("sampleSeed"), 1, Long.MIN_VALUE, Long.MAX_VALUE);
    Node show = parts.remove("show");
    SweepFile read =
        new SweepFile(
            ScenarioFile.of(file, parts),
            seeds,
            swept,
            samples,
            sampleSeed,
            names(file, show),
            show == null ? 1 : show.line(),
            text);
    read.requireBounds();
    return read;
  }

  private static Seeds.Range seeds(String file, @Nullable Node node) {
    String text = node instanceof Node.Text written ? written.value() : "";
    try {
      return Seeds.Range.of(text);
    } catch (BadInput error) {
      throw BadInput.at(
          file,
          node == null ? 1 : node.line(),
          "seeds: "
              + (node == null ? "''" : node.shown())
              + ": expected the seeds of each point, such as 1..20");
    }
  }

  private static long whole(
      String file, String key, @Nullable Node node, long standard, long min, long max) {
    if (node == null) {
      return standard;
    }
    try {
      return Quantities.whole(node instanceof Node.Text text ? text.value() : "", min, max);
    } catch (BadInput error) {
      throw BadInput.at(file, node.line(), key + ": " + error.getMessage());
    }
  }

  private static List<String> names(String file, @Nullable Node node) {
    if (node == null) {
      return List.of();
    }
    List<String> names = new ArrayList<>();
    List<Node> items = node instanceof Node.Listing list ? list.items() : List.of(node);
    for (Node item : items) {
      if (!(item instanceof Node.Text text) || text.value().isEmpty()) {
        throw BadInput.at(file, item.line(), "show: expected names of measures, such as [end_s]");
      }
      names.add(text.value());
    }
    return names;
  }

  private void requireBounds() {
    long points = samples;
    if (samples == 0) {
      points = 1;
      for (SweptKey key : swept) {
        if (key.listed().isEmpty()) {
          throw BadInput.at(
              scenario.file(),
              key.line(),
              key.key() + ": expected a number of values, 'in 5', or 'samples:' in the file");
        }
        points = Math.min(MOST_RUNS, points * key.listed().size());
      }
    }
    if (points > MOST_POINTS || points * seeds.size() > MOST_RUNS) {
      throw new BadInput(
          "%s: %d points with %d seeds: expected at most %d points and %d runs"
              .formatted(scenario.file(), points, seeds.size(), MOST_POINTS, MOST_RUNS));
    }
  }

  /** The values of each point, in the order of {@link #swept}. */
  List<List<String>> points() {
    return samples == 0 ? grid() : latinHypercube();
  }

  /** All combinations; the last key varies fastest. */
  private List<List<String>> grid() {
    List<List<String>> points = List.of(List.of());
    for (SweptKey key : swept) {
      List<List<String>> longer = new ArrayList<>();
      for (List<String> point : points) {
        for (String value : key.listed()) {
          List<String> more = new ArrayList<>(point);
          more.add(value);
          longer.add(more);
        }
      }
      points = longer;
    }
    return points;
  }

  /** Of each key, each of as many equal parts as there are points has one value (McKay 1979). */
  private List<List<String>> latinHypercube() {
    List<List<String>> points = new ArrayList<>();
    for (int i = 0; i < samples; i++) {
      points.add(new ArrayList<>());
    }
    for (SweptKey key : swept) {
      Rng rng = new Rng(sampleSeed).fork(key.key());
      int[] order = new int[samples];
      for (int i = 0; i < samples; i++) {
        int j = rng.nextInt(i + 1);
        order[i] = order[j];
        order[j] = i;
      }
      for (int i = 0; i < samples; i++) {
        points.get(i).add(key.at((order[i] + rng.nextDouble()) / samples));
      }
    }
    return points;
  }

  /**
   * The request of a point, for an app of {@code demos}.
   *
   * @throws BadInput naming the file's line, the key, the value and the expected form
   */
  RunRequest request(Demos demos, List<String> point) {
    RunRequest.Builder builder = scenario.request(demos);
    for (int i = 0; i < point.size(); i++) {
      SweptKey key = swept.get(i);
      builder.set(scenario.file() + ":" + key.line() + ": ", key.key(), point.get(i));
    }
    RunRequest request = builder.build();
    try {
      request.plan(seeds.first()).simulation().build();
    } catch (BadInput error) {
      throw new BadInput(
          "%s:%d: the point %s: %s"
              .formatted(
                  scenario.file(), swept.getFirst().line(), text(point), error.getMessage()));
    }
    return request;
  }

  /**
   * Checks the measures to show.
   *
   * @param measures of the runs so far
   * @throws BadInput if one is not among them
   */
  void requireShown(SortedSet<String> measures) {
    for (String measure : show) {
      if (!measures.contains(measure)) {
        throw BadInput.at(
            scenario.file(),
            showLine,
            "show: %s: expected some of %s"
                .formatted(BadInput.quote(measure), String.join(" ", measures)));
      }
    }
  }

  private String text(List<String> point) {
    List<String> words = new ArrayList<>();
    for (int i = 0; i < point.size(); i++) {
      words.add(swept.get(i).key() + "=" + point.get(i));
    }
    return String.join(" ", words);
  }
}
