package org.starl.lang.check;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Sizes;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;

/** The numbers of states in {@code docs/language.md}, with the defaults of {@code starl check}. */
@Tag("long")
class SizesOfTheManualTest {

  private static final int MOST_STATES = 1_000_000;

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          Mutex_decls | the mutex with 3 robots and 2 zones has %,d states
          Registration_decls | registration with 3 ids and numbers to 2 has %,d
          Election_decls | elections %,d
          Barrier_decls | barriers %,d
          Pipeline_decls | the mutex on sequences with 3 robots, 2 zones and tickets to 2 has %,d
          """)
  void automatonHasTheStatesThatTheManualSays(String name, String words)
      throws IOException, SourceErrors {
    Path file = Path.of("../pvs/starl").resolve(name + ".starl").toAbsolutePath();
    Automaton automaton = new SourceReader().read(file).getLast();
    Map<String, Integer> opaque = new LinkedHashMap<>();
    Machine.opaqueTypes(automaton).forEach(type -> opaque.put(type, opaque.isEmpty() ? 3 : 2));
    Sizes sizes = new Sizes(opaque, 2, 2);
    Search.Result result =
        new Search(new Machine(automaton, sizes), sizes, Map.of(), true, MOST_STATES).run();
    assertThat(result.finding()).isEmpty();
    assertThat(result.isComplete()).isTrue();
    String manual = Files.readString(Path.of("../docs/language.md")).replaceAll("\\s+", " ");
    assertThat(manual).contains(String.format(Locale.ROOT, words, result.states()));
  }
}
