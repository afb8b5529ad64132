package org.starl.lang.check;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;

/** Models that refine others, and their mutants. */
public final class RefinementModels {

  /** A model, a text of it, another one in its place, and the action that is no abstract step then. */
  public static final String MUTANTS =
      """
      TwoPhase | is decideAbort(r), | is nothing, | chooseToAbort
      TwoPhase | pre decision = open, forall r: RM :: r in known | pre decision = open | learnCommit
      TwoPhase | if rmState(r) = prepared then decideCommit(r) | decideCommit(r) | learnCommit
      TwoPhase | prepared -> prepared | prepared -> working | prepare
      TwoPhase | eff rmState(r) := committed | eff rmState(r) := aborted | learnCommit
      LockServer | forall j: PIDS :: i != j => wants(i) disjoint table(j) | true | enter
      LockServer | eff table(i) := has(i) | eff table(i) := {}, has(i) := {} | freed
      LockServer | od_mutex(i, wants(i)) | od_mutex(i, {}) | enter
      Everybody | if mux.crit_set(i) = {} then nothing else | if mux.crit_set(i) = {} then | leave
      Everybody | do_mutex(i, RS, all) | do_mutex(i, RS, {i}) | ask
      """;

  private RefinementModels() {}

  /** Where a model is. */
  public static Path file(String name) {
    return Path.of("src/test/resources/refines/" + name + ".starl").toAbsolutePath();
  }

  /** A model without invariants, and with another text. */
  public static Automaton mutant(String name, String from, String to)
      throws IOException, SourceErrors {
    String text = Files.readString(file(name)).replaceAll("\ninvariant [^:]+:(.+|\n )*", "\n");
    assertThat(text).contains(from);
    SourceReader reader = new SourceReader();
    return reader.look(name + ".starl", text.replace(from, to), file(name)).automata().getLast();
  }
}
