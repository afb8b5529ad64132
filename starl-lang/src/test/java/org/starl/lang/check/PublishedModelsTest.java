package org.starl.lang.check;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Sizes;
import org.starl.lang.prove.Prover;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Type.Field;
import org.starl.lang.verdict.Verdict;

/** Models that others have published have the numbers of states that they tell. */
class PublishedModelsTest {

  private static final long LIMIT = 1_000_000;

  private static Automaton model(String name) throws IOException, SourceErrors {
    Path file = Path.of("src/test/resources/models/" + name + ".starl");
    return new SourceReader().read(file.toAbsolutePath()).getLast();
  }

  /** With values of parameters, such as {@code last} and {@code 1}. */
  private static Search.Result checked(
      Automaton automaton, Sizes sizes, boolean isSymmetric, String... values) throws SourceErrors {
    Machine machine = new Machine(automaton, sizes);
    Map<String, Object> given = new LinkedHashMap<>();
    for (int i = 0; i < values.length; i += 2) {
      Field parameter = machine.parameters().get(i / 2);
      assertThat(parameter.name()).isEqualTo(values[i]);
      given.put(
          values[i],
          machine.value(
              SourceReader.readExpression(
                  automaton, machine.elements(), parameter.type(), "value", values[i + 1])));
    }
    Search.Result result = new Search(machine, sizes, given, isSymmetric, 1_000_000).run();
    assertThat(result.finding()).isEmpty();
    return result;
  }

  @Test
  void readersAndWritersWaitInAList() throws IOException, SourceErrors {
    Automaton automaton = model("ReadersWriters");
    Search.Result result = checked(automaton, new Sizes(Map.of("Actors", 3), 6, 1), false);
    assertThat(result.states()).isEqualTo(21_527);
    assertThat(result.verdict()).isEqualTo(Verdict.HOLDS);
    assertThat(new Prover(automaton, LIMIT, (name, script) -> {}).prove().lines("x.starl"))
        .contains("ReadersWriters: Safety holds, for any number of Actors");
  }

  @Test
  void votersBeginBelowTheFirstBallot() throws IOException, SourceErrors {
    Automaton automaton = model("Voting");
    Search.Result result =
        checked(
            automaton,
            new Sizes(Map.of("Acceptor", 3, "Value", 2), 1, 1),
            true,
            "Quorum",
            "{{bot0, bot1}, {bot0, bot2}, {bot1, bot2}}",
            "last",
            "1");
    assertThat(result.states()).isEqualTo(77);
    assertThat(result.verdict()).isEqualTo(Verdict.HOLDS);
    assertThat(new Prover(automaton, LIMIT, (name, script) -> {}).prove().lines("x.starl"))
        .contains("Voting: Votes holds, for any number of Acceptor and Value");
  }
}
