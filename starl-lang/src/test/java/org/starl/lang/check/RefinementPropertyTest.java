package org.starl.lang.check;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Label;
import net.jqwik.api.Property;
import net.jqwik.api.ShrinkingMode;
import net.jqwik.api.Tag;
import net.jqwik.api.statistics.Statistics;
import org.starl.lang.eval.Beyond;
import org.starl.lang.eval.EvalError;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Row;
import org.starl.lang.eval.Sizes;
import org.starl.lang.prove.Claim;
import org.starl.lang.prove.Prover;
import org.starl.lang.prove.Report;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;
import org.starl.lang.verdict.Verdict;

/** A refinement is decided as by both automata alone, step by step. */
class RefinementPropertyTest {

  private static final Sizes SIZES = new Sizes(Map.of("PIDS", 2), 2, 2);

  /** An automaton, and another one of the same state that may differ in an action. */
  private record Pair(Automaton spec, Automaton alone, Automaton refining) {

    static Pair of(long seed) throws SourceErrors {
      Random random = new Random(seed);
      String source = new RandomAutomaton(random).source().replaceFirst("\ninvariant .*", "");
      String spec = source.replace("automaton Random", "automaton Spec");
      String[] lines = source.split("\n");
      StringBuilder steps = new StringBuilder();
      for (int i = 0; i < lines.length; i++) {
        if (lines[i].startsWith("action ")) {
          String parameters = lines[i].contains("c: nat") ? "(c)" : "(i, j)";
          String name = lines[i].substring(7, 9) + parameters;
          boolean isStep = random.nextInt(8) > 0;
          steps.append(", ").append(name).append(" is ").append(isStep ? name : "nothing");
        } else if (lines[i].startsWith("  pre ") && random.nextInt(6) == 0) {
          lines[i] = "  pre n < 2";
        } else if (lines[i].startsWith("  eff ") && random.nextInt(6) == 0) {
          lines[i] = "  eff " + lines[i].substring(6).split(", ")[0];
        }
      }
      String other = String.join("\n", lines);
      String refines =
          "\nrefines spec: Spec[PIDS] by s := s, n := n, o := o, m := m, l := l, z := z" + steps;
      SourceReader reader = new SourceReader();
      return new Pair(
          reader.read("spec.starl", spec).getLast(),
          reader.read("alone.starl", other).getLast(),
          reader.read("refining.starl", spec + "\n" + other + refines).getLast());
    }
  }

  @Property(tries = 400, shrinking = ShrinkingMode.OFF)
  @Label("a step is a refinement's step if the other automaton takes it, too")
  @Tag("long")
  void refinementIsDecidedAsByBothAlone(@ForAll long seed) throws SourceErrors {
    Pair pair = Pair.of(seed);
    Search alone = search(pair.alone, seed);
    Search.Result own = alone.run();
    if (own.finding().isPresent()) {
      return; // a step without a value
    }
    Search.Result result = search(pair.refining, seed).run();
    boolean isRefined = isRefined(pair, alone.visited());
    Statistics.label("refined")
        .collect(isRefined)
        .coverage(all -> {
          all.check(true).percentage(percent -> percent > 15);
          all.check(false).percentage(percent -> percent > 15);
        });
    if (isRefined) {
      assertThat(result.finding()).isEmpty();
      assertThat(result.verdict()).isEqualTo(own.verdict());
      assertThat(result.states()).isEqualTo(own.states());
    } else {
      assertThat(result.verdict()).isNotEqualTo(Verdict.HOLDS);
      assertThat(result.finding().isPresent() || result.beyond() > own.beyond()).isTrue();
    }
  }

  @Property(tries = 60, shrinking = ShrinkingMode.OFF)
  @Label("what is proved of a refinement is not refuted by a search")
  @Tag("long")
  void whatIsProvedIsNotRefuted(@ForAll long seed) throws SourceErrors {
    Pair pair = Pair.of(seed);
    Report report = new Prover(pair.refining, 1_000_000, (title, text) -> {}).prove();
    Optional<Claim> claim = report.claim("refinement spec");
    boolean isProved = claim.isPresent() && claim.get().isGood();
    Statistics.label("proved")
        .collect(isProved)
        .coverage(all -> all.check(true).percentage(percent -> percent > 5));
    if (isProved) {
      assertThat(search(pair.refining, seed).run().finding().map(Finding::name))
          .isNotEqualTo(Optional.of("refinement spec"));
    }
  }

  private static Search search(Automaton automaton, long seed) {
    return new Search(new Machine(automaton, SIZES), SIZES, Map.of(), seed % 2 == 0, 1_000_000);
  }

  private static boolean isRefined(Pair pair, List<Row> states) {
    Machine machine = new Machine(pair.alone, SIZES);
    Machine spec = new Machine(pair.spec, SIZES);
    boolean[] isRefined = {true};
    for (Row state : states) {
      machine.steps(
          state,
          new Machine.Steps() {
            @Override
            public void step(int action, Object[] arguments, Row after) {
              isRefined[0] &= isStep(pair, spec, state, action, List.of(arguments), after);
            }
          });
    }
    return isRefined[0];
  }

  private static boolean isStep(
      Pair pair, Machine spec, Row state, int action, List<Object> arguments, Row after) {
    String name = pair.alone.actions().get(action).name();
    if (pair.refining.refinements().getFirst().steps().get(name).isEmpty()) {
      return after.equals(state);
    }
    try {
      return spec.firstFalse(state, action, arguments).isEmpty()
          && spec.after(state, action, arguments).equals(after);
    } catch (EvalError | Beyond e) {
      return false;
    }
  }
}
