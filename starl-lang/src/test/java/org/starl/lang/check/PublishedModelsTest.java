package org.starl.lang.check;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Sizes;
import org.starl.lang.prove.Prover;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;
import org.starl.lang.verdict.Verdict;

/** Models that others have published have the numbers of states that they tell. */
class PublishedModelsTest {

  private static final long LIMIT = 1_000_000;

  private static Automaton model(String name) throws IOException, SourceErrors {
    Path file = Path.of("src/test/resources/models/" + name + ".starl");
    return new SourceReader().read(file.toAbsolutePath()).getLast();
  }

  private static Search.Result checked(Automaton automaton, Sizes sizes, boolean isSymmetric) {
    Machine machine = new Machine(automaton, sizes);
    Search.Result result = new Search(machine, sizes, Map.of(), isSymmetric, 1_000_000).run();
    assertThat(result.finding()).isEmpty();
    return result;
  }

  @Test
  void readersAndWritersWaitInAList() throws IOException, SourceErrors {
    Automaton automaton = model("ReadersWriters");
    Search.Result result = checked(automaton, new Sizes(Map.of("Actors", 3), 6, 1), false);
    assertThat(result.states()).isEqualTo(21_527);
    assertThat(result.verdict()).isEqualTo(Verdict.HOLDS);
    assertThat(new Prover(automaton, LIMIT, (name, script) -> {}).prove().lines())
        .contains("ReadersWriters: Safety holds, for any number of Actors");
  }
}
