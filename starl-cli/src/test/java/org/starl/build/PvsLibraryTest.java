package org.starl.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/**
 * What ties {@code pvs/} to the rest of the project and can be told without PVS. That everything is
 * proved is for {@code pvs/check} to say; here only that what it recorded is about these sources.
 */
class PvsLibraryTest {

  /** {@code Mutex_decls}, and what is cited of it if anything is: {@code Mutex_decls.Exclusive}. */
  private static final Pattern CITATION =
      Pattern.compile("\\b([A-Z][A-Za-z]*_\\w+)\\.([A-Za-z]\\w*\\??)|\\b[A-Z]\\w*_decls\\b");

  private static final Pattern ROW_OF_SPECIFICATIONS =
      Pattern.compile("\\| `\\w+` \\| `(?:\\w+\\.)?(\\w+)` \\| `(\\w+)` \\|");
  private static final Pattern ROW_OF_PROOFS = Pattern.compile("(?m)^\\| `(\\w+)\\.(\\w+)` \\|");
  private static final Pattern ROW_OF_THE_CHAIN =
      Pattern.compile("(?m)^(\\| `\\w+` \\| (?:refines|has as a component) `\\w+` \\| `\\w+` \\|)");
  private static final Pattern AUTOMATON =
      Pattern.compile("class \\w+\\s+implements Automaton<(\\w+)\\.States, (\\w+)>");
  private static final Pattern THEORY = Pattern.compile("= \"(\\w+)\";");
  private static final Pattern RECORD = Pattern.compile("\\brecord (\\w+)\\(");

  /** A theory, the hash that was agreed first, and the present one, which has a reason. */
  private static final Pattern AGREED =
      Pattern.compile("(?m)^(\\w+) ([0-9a-f]{16})(?: -> ([0-9a-f]{16}): .+)?$");

  private static final Pattern SUM = Pattern.compile("(?m)^([A-Za-z]\\w*) (\\S+)$");

  private final Repository repository = Repository.here();
  private final PvsLibrary library = PvsLibrary.of(repository);

  @Test
  void theRecordMatchesTheSources() {
    SortedMap<String, String> record = record();
    assertThat(record.get("sources"))
        .as("pvs/CHECKED is about other sources: run pvs/check, which needs PVS, and commit it")
        .isEqualTo(library.hash());
    for (String theory : library.theories()) {
      assertThat(record).as("pvs/CHECKED").containsKey(theory);
      assertThat(Integer.parseInt(record.get(theory)))
          .as("formulas of %s that are proved", theory)
          .isGreaterThanOrEqualTo(library.formulas(theory).size());
    }
  }

  /** As pvs/check asks, which needs PVS. */
  @Test
  void everyTheorySaysWhatWasAgreed() {
    SortedMap<String, String> agreed = new TreeMap<>();
    AGREED
        .matcher(repository.text("pvs/STATEMENTS"))
        .results()
        .forEach(line ->
            agreed.put(line.group(1), line.group(3) == null ? line.group(2) : line.group(3)));
    SortedMap<String, String> said = new TreeMap<>();
    library.theories().forEach(theory -> said.put(theory, library.said(theory)));
    said.put("top", library.said("top"));
    assertThat(said)
        .as("pvs/STATEMENTS; who means a change writes ' -> NEW: why' after the first hash")
        .isEqualTo(agreed);
  }

  @Test
  void everyTheoryIsChecked() {
    assertThat(library.imported()).as("imported by pvs/top.pvs").isEqualTo(library.theories());
  }

  @Test
  void everyTheoryBeginsWithWhatItSays() {
    for (String theory : library.theories()) {
      assertThat(library.head(theory)).as("head of pvs/%s.pvs", theory).hasSizeGreaterThan(80);
    }
  }

  @Test
  void everyLemmaAndActionThatIsCitedExists() {
    List<String> wrong = new ArrayList<>();
    for (SourceFile file : repository.textFiles()) {
      Matcher cited = CITATION.matcher(file.path().contains("/test/") ? "" : file.text());
      while (cited.find()) {
        if (!exists(cited.group(), cited.group(1), cited.group(2))) {
          wrong.add(file.path() + " cites " + cited.group());
        }
      }
    }
    assertThat(wrong).as("what pvs/ does not declare").isEmpty();
  }

  private boolean exists(String cited, @Nullable String theory, @Nullable String name) {
    if (theory == null || name == null) {
      return library.has(cited);
    }
    boolean isFile = List.of("pvs", "starl").contains(name);
    boolean isOurs = library.has(theory) || theory.endsWith("_decls");
    return !isOurs || (isFile ? library.has(theory) : library.declares(theory, name));
  }

  @Test
  void everyLemmaThatIsSaidToBeProvedIsThere() {
    List<String> wrong = new ArrayList<>();
    Matcher row = ROW_OF_SPECIFICATIONS.matcher(repository.text("docs/specifications.md"));
    int rows = 0;
    while (row.find()) {
      rows++;
      if (!row.group(1).equals(row.group(2)) && !library.declares(row.group(2), row.group(1))) {
        wrong.add(row.group());
      }
    }
    assertThat(rows).isGreaterThan(20);
    assertThat(wrong).as("rows of docs/specifications.md that pvs/ does not know").isEmpty();
  }

  @Test
  void theDocumentationHasEveryTheorem() {
    List<String> stated = new ArrayList<>();
    for (String theory : library.theories()) {
      library.theorems(theory).forEach(theorem -> stated.add(theory + "." + theorem));
    }
    List<String> known = new ArrayList<>();
    for (String theory : library.theories()) {
      library.formulas(theory).forEach(formula -> known.add(theory + "." + formula));
    }
    List<String> told =
        ROW_OF_PROOFS
            .matcher(repository.text("docs/proofs.md"))
            .results()
            .map(row -> row.group(1) + "." + row.group(2))
            .toList();
    assertThat(told).as("rows of docs/proofs.md").doesNotHaveDuplicates().containsAll(stated);
    assertThat(known).as("formulas in pvs/").containsAll(told);
  }

  @Test
  void theChainIsThatOfTheTheories() {
    assertThat(
            ROW_OF_THE_CHAIN
                .matcher(repository.text("docs/proofs.md"))
                .results()
                .map(row -> row.group(1)))
        .as("the chain of docs/proofs.md")
        .containsExactlyInAnyOrderElementsOf(library.links());
  }

  @Test
  void everyExecutableAutomatonHasTheActionsOfItsTheory() {
    int automata = 0;
    for (SourceFile file : repository.textFiles()) {
      Matcher automaton = AUTOMATON.matcher(file.text());
      if (!file.path().contains("/main/") || !automaton.find()) {
        continue;
      }
      automata++;
      Matcher theory = THEORY.matcher(file.text());
      assertThat(theory.find()).as("%s names its theory", file.path()).isTrue();
      String actions = repository.text(file.path().replace(automaton.group(1), automaton.group(2)));
      assertThat(RECORD.matcher(actions).results().map(match -> match.group(1)))
          .as("actions of %s", file.path())
          .containsExactlyInAnyOrderElementsOf(library.actions(theory.group(1)));
    }
    assertThat(automata).isGreaterThan(1);
  }

  private SortedMap<String, String> record() {
    SortedMap<String, String> record = new TreeMap<>();
    SUM.matcher(repository.text("pvs/CHECKED"))
        .results()
        .forEach(line -> record.put(line.group(1), line.group(2)));
    return record;
  }
}
