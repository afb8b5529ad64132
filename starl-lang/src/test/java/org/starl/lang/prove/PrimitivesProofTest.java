package org.starl.lang.prove;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.lang.prove.Claim.Verdict;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Action.Conjunct;
import org.starl.lang.tree.Action.Effect;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Expr;

/** The primitives' automata, as they stand in {@code pvs/starl}, and wrong ones. */
@Tag("long")
class PrimitivesProofTest {

  private static final long LIMIT = 10_000_000;

  /** What the barrier's invariants need besides themselves: a missing process is in no later generation. */
  private static final String LEFT_OUT =
      """
      invariant Left_out:
        forall h, g: nat ::
          h > 0 and outcome(h) is failed and h < g => outcome(h).missing disjoint members(g)
      """;

  /** Holds of the mutex, and not of some wrong ones. */
  private static final String WAITS =
      """
      invariant Waits: forall i: PIDS :: req_set(i) != {} => crit_set(i) = {}
      """;

  @ParameterizedTest
  @ValueSource(
      strings = {
        "Mutex_decls",
        "Mutex_group_decls",
        "Registration_decls",
        "SetAgreement_decls",
        "Election_decls",
        "Barrier_decls",
        "Geocast_decls",
        "MotionControl_decls"
      })
  void primitivesKeepTheirInvariantsForAnyNumberOfRobots(String name)
      throws IOException, SourceErrors {
    Report report = prove(read(name, name.equals("Barrier_decls") ? LEFT_OUT : ""));
    assertThat(report.claims()).extracting(Claim::verdict).containsOnly(Verdict.PROVED);
  }

  @Test
  void intersectionKeepsItsInvariants() throws IOException, SourceErrors {
    Report report = prove(read("Traffic_decls", ""));
    assertThat(report.isProved()).isTrue();
    assertThat(report.claim("Held").orElseThrow().verdict()).isEqualTo(Verdict.PROVED);
    assertThat(report.claim("Peers").orElseThrow().verdict()).isEqualTo(Verdict.PROVED);
  }

  @Test
  void mutexThatMayBreakAnInvariantIsNotProved() throws IOException, SourceErrors {
    assertThat(caught(read("Mutex_decls", WAITS)))
        .containsExactly(
            "do_mutex without crit_set(i) = {}",
            "do_mutex with not crit_set(i) = {}",
            "od_mutex without free_for?(i, RS)",
            "od_mutex with not free_for?(i, RS)",
            "od_mutex without effect 2");
  }

  @Test
  void registrationThatMayBreakAnInvariantIsNotProved() throws IOException, SourceErrors {
    assertThat(caught(read("Registration_decls", "")))
        .contains(
            "unregister without i in asked",
            "decide without list(number) minus gone subset L",
            "decide without effect 2",
            "decide without effect 3",
            "learn without n <= number");
  }

  /** The automata with one condition dropped or denied, or one effect dropped, that are not proved. */
  private static List<String> caught(Automaton automaton) {
    List<String> caught = new ArrayList<>();
    for (Action action : automaton.actions()) {
      for (int i = 0; i < action.pre().size(); i++) {
        Conjunct conjunct = action.pre().get(i);
        List<Conjunct> less = without(action.pre(), i);
        tryOut(automaton, action, less, action.eff(), "without " + conjunct.text(), caught);
        less.add(new Conjunct(new Expr.Not(conjunct.condition(), action.pos()), conjunct.text()));
        tryOut(automaton, action, less, action.eff(), "with not " + conjunct.text(), caught);
      }
      for (int i = 0; i < action.eff().size(); i++) {
        List<Effect> less = without(action.eff(), i);
        tryOut(automaton, action, action.pre(), less, "without effect " + (i + 1), caught);
      }
    }
    return caught;
  }

  private static <T> List<T> without(List<T> list, int index) {
    List<T> less = new ArrayList<>(list);
    less.remove(index);
    return less;
  }

  private static void tryOut(
      Automaton of,
      Action action,
      List<Conjunct> pre,
      List<Effect> eff,
      String what,
      List<String> caught) {
    List<Action> actions = new ArrayList<>(of.actions());
    actions.set(
        actions.indexOf(action),
        new Action(action.name(), action.parameters(), pre, eff, List.of(), "", action.pos()));
    Automaton mutant =
        new Automaton(
            of.name(),
            of.typeParameters(),
            of.valueParameters(),
            of.assumptions(),
            of.types(),
            of.state(),
            of.uses(),
            of.functions(),
            of.start(),
            actions,
            of.invariants(),
            of.javaClass(),
            of.javaTypes(),
            of.comment(),
            of.pos());
    if (!prove(mutant).isProved()) {
      caught.add(action.name() + " " + what);
    }
  }

  private static Report prove(Automaton automaton) {
    return new Prover(automaton, LIMIT, (name, text) -> {}).prove();
  }

  /** The automaton of a source, with more invariants. */
  private static Automaton read(String name, String more) throws IOException, SourceErrors {
    Path file = Path.of("../pvs/starl").resolve(name + ".starl").toAbsolutePath();
    if (more.isEmpty()) {
      return new SourceReader().read(file).getFirst();
    }
    return new SourceReader()
        .read(file.toString(), Files.readString(file) + "\n" + more)
        .getFirst();
  }
}
