package org.starl.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/**
 * {@code docs/specifications.md} names a planted bug for each lemma of each monitor that is shipped.
 * Monitors are found in the sources. Their lemmas are the text constants in {@code lemmas()}, or given
 * to {@code lemma}, {@code progress} or {@code Conformance}; in the same file or one beside it.
 */
class SpecificationsTest {

  private static final Path ROOT = Path.of("..");
  private static final List<String> MODULES =
      List.of(
          "starl-core",
          "starl-primitives",
          "starl-primitives/states",
          "starl-sim",
          "starl-sim/view",
          "starl-apps",
          "starl-cli",
          "starl-cli/launch",
          "starl-cli/bench",
          "starl-apps/kotlin");
  private static final Pattern MONITOR =
      Pattern.compile(
          "(?<!abstract )(?<!abstract static )\\bclass (\\w+)(?: extends (?:\\w*Conformance|InstanceSpec|InstanceMonitor|LemmaMonitor)\\b[^{;]*|"
              + "[^{;]*(?: implements |\\) : )[^{;]*\\b(?:App)?Monitor\\b(?!\\.)[^{;]*)\\{");
  private static final Pattern CONSTANT =
      Pattern.compile("(?:static final String|const val) (\\w+) = \"([^\"]+)\"");
  private static final Pattern LEMMAS =
      Pattern.compile("List<String> lemmas(?:\\(\\) \\{|\\s*=)(.*?);\\s*\\n", Pattern.DOTALL);
  private static final Pattern LEMMAS_IN_KOTLIN =
      Pattern.compile("fun lemmas\\(\\)[^=]* = listOf\\(([^)]*)\\)");
  private static final Pattern OF_CONFORMANCE = Pattern.compile("super\\(\\s*([\\w.]+),\\s*\"");
  private static final Pattern NAMED =
      Pattern.compile("\\b(?:lemma|progress)\\(\\s*(?:\\w+\\.)?(\\w+),");
  private static final Pattern ADDED = Pattern.compile("lemmas\\.add\\(([\\w.]+)\\)");
  private static final Pattern NAME = Pattern.compile("\\b([A-Z][A-Z_]+)\\b");
  private static final Pattern ROW =
      Pattern.compile("\\| `(\\w+)` \\| `([\\w.]+)` \\| [^|]+ \\| [^|]+ \\| `(\\w+)#(\\w+)` \\|");

  private static final SortedMap<Path, String> SOURCES = new TreeMap<>();

  private record Row(String monitor, String lemma, String testClass, String method) {
    String of() {
      return monitor + " " + lemma;
    }
  }

  @BeforeAll
  static void readSources() throws IOException {
    for (String module : MODULES) {
      try (Stream<Path> files = Files.walk(ROOT.resolve(module).resolve("src"))) {
        for (Path file : files.filter(SpecificationsTest::isSource).toList()) {
          SOURCES.put(file, Files.readString(file));
        }
      }
    }
  }

  private static boolean isSource(Path file) {
    return file.toString().endsWith(".java") || file.toString().endsWith(".kt");
  }

  private static List<Row> rows() throws IOException {
    List<Row> rows = new ArrayList<>();
    Matcher row = ROW.matcher(Files.readString(ROOT.resolve("docs/specifications.md")));
    while (row.find()) {
      rows.add(new Row(row.group(1), row.group(2), row.group(3), row.group(4)));
    }
    return rows;
  }

  /** Each as {@code Monitor lemma}. */
  private static List<String> lemmas() {
    List<String> found = new ArrayList<>();
    SOURCES.forEach((file, text) -> {
      Matcher monitor = MONITOR.matcher(text);
      if (file.toString().contains("main") && monitor.find()) {
        String constants = textsBeside(file);
        List<String> lemmas = lemmasOf(text, constants);
        // A monitor of another one's violations has that one's lemmas.
        boolean isWrapper = text.contains("return monitor.lemmas();");
        assertThat(lemmas.isEmpty()).as("no lemmas in %s", file).isEqualTo(isWrapper);
        lemmas.forEach(lemma -> found.add(monitor.group(1) + " " + lemma));
      }
    });
    return found;
  }

  private static List<String> lemmasOf(String monitor, String others) {
    StringBuilder named = new StringBuilder();
    for (Pattern pattern : List.of(LEMMAS, LEMMAS_IN_KOTLIN, OF_CONFORMANCE, NAMED, ADDED)) {
      pattern.matcher(monitor).results().forEach(match -> named.append(match.group(1)).append(' '));
    }
    List<String> lemmas = new ArrayList<>();
    for (String constant :
        NAME.matcher(named).results().map(match -> match.group(1)).distinct().toList()) {
      String value = constant(monitor, constant);
      lemmas.add(value.isEmpty() ? constant(others, constant) : value);
    }
    return lemmas;
  }

  private static String constant(String text, String name) {
    return CONSTANT
        .matcher(text)
        .results()
        .filter(match -> match.group(1).equals(name))
        .map(match -> match.group(2))
        .findFirst()
        .orElse("");
  }

  private static String textsBeside(Path file) {
    StringBuilder all = new StringBuilder();
    SOURCES.forEach((other, text) -> {
      if (file.getParent().equals(other.getParent())) {
        all.append(text);
      }
    });
    return all.toString();
  }

  @Test
  void everyLemmaOfEveryMonitorHasItsPlantedBugAndNoOtherHas() throws IOException {
    List<String> lemmas = lemmas();
    assertThat(lemmas).hasSizeGreaterThan(30).doesNotHaveDuplicates();
    assertThat(rows()).extracting(Row::of).containsExactlyInAnyOrderElementsOf(lemmas);
  }

  @Test
  void noTwoLemmasHaveOneName() throws IOException {
    assertThat(rows()).extracting(Row::lemma).doesNotHaveDuplicates();
  }

  @Test
  void everyTestThatIsNamedIsThereAndNamesTheLemma() throws IOException {
    for (Row row : rows()) {
      String test = "";
      String monitor = "";
      for (Path file : SOURCES.keySet()) {
        test += isClass(file, row.testClass()) ? SOURCES.get(file) : "";
        monitor += isClass(file, row.monitor()) ? textsBeside(file) : "";
      }
      assertThat(test).as("%s", row).containsPattern("  (void|fun) " + row.method() + "\\(");
      List<String> names = new ArrayList<>(List.of("\"" + row.lemma() + "\"", ", " + row.lemma()));
      CONSTANT
          .matcher(monitor)
          .results()
          .filter(match -> match.group(2).equals(row.lemma()))
          .forEach(match -> names.add("." + match.group(1)));
      assertThat(names).as("%s", row).anyMatch(test::contains);
    }
  }

  private static boolean isClass(Path file, String name) {
    return file.endsWith(name + ".java") || file.endsWith(name + ".kt");
  }
}
