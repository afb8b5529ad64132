package org.starl.lang.check;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.lang.eval.EvalError;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Row;
import org.starl.lang.eval.Sizes;
import org.starl.lang.eval.Successors;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;

class SuccessorsTest {

  private static final int MOST_STATES = 600;

  /** Notes steps as texts. */
  private static final class Notes implements Successors.Steps {

    final List<String> notes = new ArrayList<>();
    private final Machine machine;
    private final Symmetry symmetry;

    Notes(Machine machine, Symmetry symmetry) {
      this.machine = machine;
      this.symmetry = symmetry;
    }

    @Override
    public void step(int action, Object[] arguments, Row after) {
      note(action, arguments, after.toString());
    }

    @Override
    public void step(int action, Object[] arguments, int[] after) {
      note(action, arguments, new Successors(machine, symmetry).row(after).toString());
    }

    @Override
    public void beyond(int action, Object[] arguments) {
      note(action, arguments, "beyond");
    }

    @Override
    public void error(int action, Object[] arguments, EvalError error) {
      note(action, arguments, String.valueOf(error.getMessage()));
    }

    private void note(int action, Object[] arguments, String what) {
      notes.add(machine.text(action, arguments) + ": " + what);
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "Barrier",
        "Election",
        "Ledger",
        "Mutex",
        "Mutex_group",
        "Pipeline",
        "Registration"
      })
  void stepsThatAreRememberedAreThoseThatAreEvaluated(String name)
      throws IOException, SourceErrors {
    Path file = Path.of("../pvs/starl").resolve(name + "_decls.starl").toAbsolutePath();
    requireEqualSteps(new SourceReader().read(file).getLast());
  }

  @ParameterizedTest
  @ValueSource(strings = {"TwoPhase", "LockServer", "Everybody"})
  void stepsOfRefinementsAreThoseThatAreEvaluated(String name) throws IOException, SourceErrors {
    requireEqualSteps(new SourceReader().read(RefinementModels.file(name)).getLast());
  }

  private static void requireEqualSteps(Automaton automaton) {
    Map<String, Integer> opaque = new LinkedHashMap<>();
    Machine.opaqueTypes(automaton).forEach(type -> opaque.put(type, opaque.isEmpty() ? 3 : 2));
    Sizes sizes = new Sizes(opaque, 2, 2);
    Machine machine = new Machine(automaton, sizes);
    Search search = new Search(machine, sizes, Map.of(), false, MOST_STATES);
    assertThat(search.run().finding()).isEmpty();
    Symmetry symmetry = new Symmetry(machine, opaque, false);
    Successors successors = new Successors(machine, symmetry);
    for (int pass = 0; pass < 2; pass++) { // the second one finds what the first one remembered
      for (Row state : search.visited()) {
        Notes evaluated = new Notes(machine, symmetry);
        machine.steps(state, evaluated);
        Notes remembered = new Notes(machine, symmetry);
        successors.steps(symmetry.representative(state), remembered);
        assertThat(remembered.notes).as(state.toString()).isEqualTo(evaluated.notes);
      }
    }
  }
}
