package org.starl.lang.java;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.starl.lang.java.Sources.proved;
import static org.starl.lang.java.Sources.read;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.lang.check.Search;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Sizes;
import org.starl.lang.pvs.PvsTheory;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.verdict.Verdict;
import org.starl.spec.automaton.Undefined;

/** {@code map[K, V]} in each tool. */
class MapTypesTest {

  /** Gray, Notes on data base operating systems, 1978: the coordinator keeps the votes in a map. */
  private static final String COMMIT =
      """
      automaton Commit[RM]
      java "x.XAutomaton"
      type Vote = yes | no
      state
        votes: map[RM, Vote]
        told: map[RM, bool]
        result: option[bool]
      start votes = {}, told = {}, result = none
      action vote(r: RM, v: Vote)
        pre not r in votes
        eff votes(r) := some(v)
      action commit
        pre result = none, forall r: RM :: r in votes and the(votes(r)) = yes
        eff result := some(true)
      action abort(r: RM)
        pre result = none, r in votes, the(votes(r)) = no
        eff result := some(false)
      action tell(r: RM)
        pre result != none, not r in told
        eff told(r) := result
      action forget(r: RM)
        pre r in told
        eff told(r) := none
      """;

  private static Search.Result checked(String text) throws SourceErrors {
    Sizes sizes = new Sizes(Map.of("RM", 2), 2, 1);
    return new Search(new Machine(read(text), sizes), sizes, Map.of(), false, 10_000).run();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '~',
      textBlock =
          """
          forall r: RM :: r in told => r in votes or result = some(false) ~ HOLDS
          forall r: RM :: r in told => r in votes                         ~ VIOLATED
          forall r: RM :: r in told => told(r) = result                   ~ HOLDS
          card(told) = card({r: RM | r in told}) and card(votes) <= 2     ~ HOLDS
          card(votes) < 2                                                 ~ VIOLATED
          votes = {} <=> card(votes) = 0                                  ~ HOLDS
          result = none => told = {}                                      ~ HOLDS
          """)
  void keysAndValuesAreFound(String invariant, Verdict verdict) throws SourceErrors {
    assertThat(checked(COMMIT + "invariant I: " + invariant).verdict()).isEqualTo(verdict);
  }

  @Test
  void statesAreAsManyAsCountedByHand() throws SourceErrors {
    // 9 maps of votes; a result after yes-yes, or after one of 5 with a no: each with 4 sets of
    // told.
    assertThat(checked(COMMIT).states()).isEqualTo(9 + 4 * (1 + 5));
  }

  @Test
  void invariantsOfMapsAreProved() throws SourceErrors {
    assertThat(
            proved(
                COMMIT
                    + """
                    invariant Agreed: forall r: RM :: r in told => told(r) = result
                    invariant Early: result = none => told = {}
                    """))
        .contains(
            "Commit: Agreed holds, for any number of RM",
            "Commit: Early holds, for any number of RM");
  }

  @Test
  void valueOfAKeyThatIsNotInTheMapIsTold() throws SourceErrors {
    String text = COMMIT.replace("r in votes, the(votes(r)) = no", "the(votes(r)) = no");
    assertThat(checked(text).finding())
        .hasValueSatisfying(finding -> {
          assertThat(finding.message()).isEqualTo("the(none) has no value");
          assertThat(finding.pos()).hasToString("16:22");
        });
    assertThat(proved(text))
        .containsSubsequence("Commit: abort has no value: the(none)", "  at x.starl:16:22");
    Compiled compiled =
        new Compiled(
            text.replace("forall r: RM :: r in votes and ", "")
                .replace("the(votes(r)) = yes\n", "votes != {}\n"));
    assertThatThrownBy(() -> compiled.enabled("abort", "r").isTrue())
        .isInstanceOf(Undefined.class)
        .hasMessage("x.starl:16:22: the(none) has no value");
    assertThat(PvsTheory.of(read(text), "x.starl")).contains("down(s`votes(r)) = no");
  }

  @Test
  void mapIsAFunctionToOptionsInTheTheory() throws SourceErrors {
    assertThat(PvsTheory.of(read(COMMIT), "x.starl"))
        .contains("votes: [RM -> lift[Vote]]", "vote(r, v): NOT up?(s`votes(r))");
  }

  @Test
  void mapIsChangedInJava() throws SourceErrors {
    String text = COMMIT.replace("forall r: RM :: r in votes and the(votes(r)) = yes", "true");
    Compiled compiled = new Compiled(text);
    assertThat(compiled.enabled("tell", "r").isTrue()).isFalse();
    compiled.step("commit");
    assertThat(compiled.enabled("forget", "r").isTrue()).isFalse();
    compiled.step("tell", "r");
    assertThat(compiled.enabled("tell", "r").isTrue()).isFalse();
    assertThat(compiled.enabled("tell", "q").isTrue()).isTrue();
    compiled.step("forget", "r");
    assertThat(compiled.enabled("tell", "r").isTrue()).isTrue();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          action a(r: RM) eff m(r) := 1       | 4:29: '1' is of type nat; expected option[nat]: some(1)
          action a(r: RM) pre 1 < m(r) | 4:25: 'm(r)' is of type option[nat]; expected real: the(m(r))
          action a(r: RM) eff m[r] := some(1) | 4:22: found '['; expected '(': the value of a map m at i is m(i)
          action a(s: map[RM -> nat])  | 4:20: found '->'; expected ',' as in 'map[K, V]', or '[K -> V]'
          action a(r: RM) pre m(r) = 1        | 4:28: '1' is of type nat, and 'm(r)' of type option[nat]; expected two of one type
          action a(n: nat) pre n in m         | 4:22: 'n' is of type nat; expected RM
          action a pre m = 0                  | 4:18: '0' is of type nat, and 'm' of type [RM -> option[nat]]; expected two of one type
          """)
  void mistakeIsTold(String action, String told) {
    assertThatThrownBy(
            () -> read("automaton A[RM]\nstate m: map[RM, nat]\nstart m = {}\n" + action))
        .hasMessage("x.starl:" + told);
  }
}
