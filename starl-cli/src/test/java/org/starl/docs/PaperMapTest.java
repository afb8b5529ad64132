package org.starl.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** {@code docs/paper-map.md} names what exists, and says so where something does not. */
class PaperMapTest {

  private static final Path DOCS = Path.of("..", "docs");
  private static final Pattern LINK = Pattern.compile("\\]\\(([^)]+)\\)");
  private static final String NOT_YET = "*not yet*";

  private static final List<String> SECTIONS =
      List.of(
          "## 1. Introduction",
          "## 2. Overview of StarL",
          "## 3. Automatic Intersection",
          "### 3.1 Intersection Coordination using StarL",
          "### 3.2 Java Implementation of ICP",
          "3.3 StarL PVS Library",
          "3.4 Overview of the PVS Theories",
          "3.5 Proving Theorems about ICP",
          "## 4. StarL Primitives",
          "### 4.1 Motion Control",
          "### 4.2 Geocast and Broadcast",
          "### 4.3 Registration",
          "### 4.4 Leader Election",
          "### 4.5 Mutual Exclusion",
          "## 5. Execution Environments",
          "### 5.1 Deploying Applications on HW Platforms",
          "### 5.2 Simulating Applications",
          "### 5.3 The ICP Application",
          "### 5.4 Other Applications",
          "## 6. Related Work",
          "## 7. Conclusions");

  private final List<String> lines = lines();

  @Test
  void everyFileNamedExists() {
    List<String> targets = links(String.join("\n", lines));
    assertThat(targets).hasSizeGreaterThan(100);
    assertThat(targets)
        .extracting(target -> target.replaceFirst("#.*", ""))
        .allSatisfy(file -> assertThat(DOCS.resolve(file).normalize()).exists());
  }

  @Test
  void everySectionHasItsTable() {
    for (String section : SECTIONS) {
      int heading =
          IntStream.range(0, lines.size())
              .filter(i -> lines.get(i).startsWith("##") && lines.get(i).contains(section))
              .findFirst()
              .orElse(-1);
      assertThat(heading).as(section).isNotNegative();
      assertThat(lines.subList(heading, heading + 5)).as(section).contains("|---|---|---|");
    }
  }

  @Test
  void smallPartsOfThePaperHaveRows() {
    String parts =
        rows().stream().map(row -> row.split("\\|", -1)[1]).collect(Collectors.joining());
    assertThat(parts).contains("TAME", "\"no backing\"", "gotopoint", "do_move");
  }

  @Test
  void everyFigureHasARow() {
    String rows = String.join("\n", rows());
    for (int figure = 1; figure <= 9; figure++) {
      assertThat(rows).containsPattern("\n\\| Figure " + figure + "\\b");
    }
  }

  @Test
  void everyRowNamesItsTestOrSaysNotYet() {
    assertThat(rows()).hasSizeGreaterThan(60);
    for (String row : rows()) {
      String[] cells = row.split("\\|", -1);
      assertThat(cells).as(row).hasSize(5);
      assertThat(cells[2]).as(row).isNotBlank();
      boolean answered = cells[3].contains(NOT_YET) || !links(cells[3]).isEmpty();
      assertThat(answered).as(row).isTrue();
    }
  }

  @Test
  void testsAreInTheColumnOfTests() {
    for (String row : rows()) {
      String[] cells = row.split("\\|", -1);
      assertThat(links(cells[2])).as(row).noneMatch(link -> link.contains("/src/test/"));
      assertThat(links(cells[3])).as(row).allMatch(link -> link.contains("/src/test/"));
    }
  }

  @Test
  void noPrimitiveAndNoAppIsForgotten() throws IOException {
    String map = String.join("\n", lines);
    for (String parent :
        List.of(
            "starl-primitives/src/main/java/org/starl/primitives",
            "starl-apps/src/main/java/org/starl/apps")) {
      try (Stream<Path> children = Files.list(Path.of("..").resolve(parent))) {
        List<String> packages =
            children
                .filter(Files::isDirectory)
                .map(child -> child.getFileName().toString())
                // Not in the paper.
                .filter(name ->
                    !List.of("fleet", "hello", "ledger", "monitor", "exhaustive").contains(name))
                .toList();
        assertThat(packages)
            .isNotEmpty()
            .allSatisfy(name -> assertThat(map).contains("(../" + parent + "/" + name + "/"));
      }
    }
  }

  private List<String> rows() {
    return lines.stream()
        .filter(line -> line.startsWith("| ") && !line.startsWith("| paper |"))
        .toList();
  }

  private static List<String> links(String text) {
    return LINK.matcher(text).results().map(match -> match.group(1)).toList();
  }

  private static List<String> lines() {
    Path map = DOCS.resolve("paper-map.md");
    try {
      return Files.readAllLines(map);
    } catch (IOException e) {
      throw new IllegalStateException(map + " cannot be read", e);
    }
  }
}
