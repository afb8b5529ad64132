package org.starl.lang.prove;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.lang.check.RefinementModels;
import org.starl.lang.prove.Claim.Verdict;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;

class ProverTest {

  private static final long LIMIT = 10_000_000;

  private static final String LOCK =
      """
      automaton Lock[PIDS]
      state
        by: option[PIDS]
        inside: set[PIDS]
        count: nat
      start by = none, inside = {}, count = 0
      action take(i: PIDS)
        pre by = none
        eff by := some(i)
      action enter(i: PIDS)
        pre by = some(i)
        eff inside := inside union {i}, count := count + 1
      action leave(i: PIDS)
        pre i in inside, count > 0
        eff inside := inside minus {i}, by := none, count := count - 1
      invariant Holder: forall i: PIDS :: i in inside => by = some(i)
      invariant Alone: forall i, j: PIDS :: i in inside and j in inside => i = j
      """;

  @Test
  void invariantsHoldForAnyNumberOfRobots() {
    assertThat(proved(LOCK).lines("x.starl"))
        .containsExactly(
            "Lock: start is possible",
            "Lock: Holder holds, for any number of PIDS",
            "Lock: Alone holds, for any number of PIDS",
            "Lock: take can happen",
            "Lock: enter can happen",
            "Lock: leave can happen");
  }

  @Test
  void namesOfTypesAreNotThoseOfTheScript() {
    String of = LOCK.replace("PIDS", "T").replace("option[T]", "option[nat]");
    assertThat(proved(of.replace("some(i)", "some(1)").replaceAll("invariant .*", "")).isProved())
        .isTrue();
  }

  /** Z3 4.14 finds two arrays equal that are not, if one is a constant one with changes everywhere. */
  @Test
  void setsInsideRecordsAreEqualOnlyIfTheirElementsAre() {
    assertThat(
            proved(
                    """
                    automaton Letters[PIDS, Zones]
                    type Letter = record(who: PIDS, at: nat, zones: set[Zones])
                    state
                      clock: [PIDS -> nat]
                      want: [PIDS -> set[Zones]]
                      sent: set[Letter]
                    start sent = {}, forall i: PIDS :: clock(i) = 0 and want(i) = {}
                    action send(i: PIDS, RS: set[Zones])
                      pre RS != {}
                      eff clock(i) := clock(i) + 1, want(i) := RS,
                          sent := sent union {Letter(who := i, at := clock(i) + 1, zones := RS)}
                    invariant Times: forall m: Letter :: m in sent => m.at <= clock(m.who)
                    invariant Names:
                      forall i: PIDS, RS: set[Zones] ::
                        Letter(who := i, at := clock(i), zones := RS) in sent and want(i) != {} =>
                          want(i) subset RS
                    """)
                .lines("x.starl"))
        .noneMatch(line -> line.contains("is not kept"))
        .anyMatch(line -> line.startsWith("Letters: Names holds"));
  }

  @Test
  void optionsOfOptionsAreTranslated() {
    String nested =
        """
        automaton Nested
        state x: option[option[nat]]
        start x = none
        action first
          eff x := some(none)
        action second
          pre x = some(none)
          eff x := some(some(1))
        invariant One: x = none or x = some(none) or the(the(x)) = 1
        """;
    assertThat(proved(nested).isProved()).isTrue();
    assertThat(proved(nested.replace("the(the(x)) = 1", "x = some(some(2))")).isProved()).isFalse();
    String lists =
        """
        automaton Lists[P]
        state l: list[list[P]]
        start l = []
        action first(p: P)
          eff l := [[p], []]
        action second
          pre l != [], head(l) != []
          eff l := tail(l)
        invariant Some: l = [] or head(l) = [] or distinct(head(l)) and distinct(l)
        """;
    assertThat(proved(lists).lines("x.starl")).contains("Lists: second can happen");
  }

  @Test
  void assumptionsAreGiven() {
    String steps =
        """
        automaton Steps[Names, most: nat, names: list[Names]]
        assume Some: most > 0
        assume Once: distinct(names) and names != [] and tail(names) != []
        state n: nat
        start n = 1
        action up
          pre n < most
          eff n := n + 1
        invariant Below: n <= most
        invariant Two: head(names) != head(tail(names))
        """;
    assertThat(proved(steps).isProved()).isTrue();
    assertThat(proved(steps.replace("assume Some: most > 0", "")).isProved()).isFalse();
    assertThat(proved(steps.replace("distinct(names) and", "")).isProved()).isFalse();
  }

  @Test
  void lengthsAndElementsOfListsAreDecided() {
    String channel =
        """
        automaton Channel[T, most: nat]
        state
          q: list[nat]
          got: list[T]
        start q = [], got = []
        action send(n: nat)
          pre length(q) < most, n > 0
          eff q := q ++ [n]
        action receive(t: T)
          pre q != []
          eff q := tail(q), got := got ++ [t]
        invariant Short: length(q) <= most
        """;
    assertThat(proved(channel).lines("x.starl"))
        .contains("Channel: Short holds, for any number of T", "Channel: receive can happen");
    String wrong = channel + "invariant First: q != [] => q(0) = 1\n";
    assertThat(proved(wrong).lines("x.starl"))
        .contains("Channel: First is not kept by send", "  after   q = [2]")
        .doesNotContain("Channel: First holds, for any number of T");
  }

  @Test
  void cardsAreExactForFewRobots() {
    String votes =
        """
        automaton Votes[P]
        type Ballot = record(n: nat, by: P)
        state
          yes: set[P]
          no: set[P]
          all: set[Ballot]
        start yes = {}, no = {}, all = {}
        action vote(i: P)
          pre let both = yes union no :: not i in both and card(both) < 3
          eff yes := yes union {i}
        action against(i: P, b: Ballot)
          pre not i in yes union no
          eff no := no union {i}, all := all union {b}
        invariant Apart: yes disjoint no
        invariant Sum: card(yes union no) = card(yes) + card(no)
        invariant Empty: card(yes) = 0 <=> yes = {}
        """;
    assertThat(proved(votes).lines("x.starl"))
        .contains(
            "Votes: Empty holds, for any number of P",
            "Votes: Sum holds for 1 to 5 of P; for more it is not decided",
            "Votes: vote can happen");
    assertThat(proved(votes + "invariant One: card(yes) <= 1\n").lines("x.starl"))
        .contains("Votes: One is not kept by vote", "  after   yes = {bot0, bot1}");
    assertThat(proved(votes + "invariant None: card(all) = card(yes)\n").lines("x.starl"))
        .contains("Votes: None is not decided for vote");
  }

  @Test
  void stepOfAUsedAutomatonChangesNothingIfItsConditionFails() {
    String room =
        """
        automaton Lamp[PIDS]
        state on: set[PIDS]
        start on = {}
        action switch(i: PIDS)
          pre on = {}
          eff on := on union {i}
        automaton Room[PIDS]
        state dark: bool
        uses lamp: Lamp[PIDS]
        start lamp.start?, dark = true
        action enter(i: PIDS)
          eff if dark then lamp.switch(i), dark := false
        invariant Dark: dark => lamp.on = {}
        invariant One: forall i, j: PIDS :: i in lamp.on and j in lamp.on => i = j
        """;
    assertThat(proved(room).isProved()).isTrue();
    assertThat(proved(room.replace("if dark then ", "")).isProved()).isFalse();
  }

  @Test
  void whatZ3DecidesForFewRobotsAloneIsSaidSo() {
    String some =
        """
        automaton Some[PIDS]
        state on: set[PIDS]
        start on = {}
        action up(i: PIDS)
          eff on := on union {i}
        invariant Rest: exists S: set[PIDS] :: forall i: PIDS :: i in S <=> not i in on
        """;
    Report report = proved(some);
    assertThat(report.isProved()).isTrue();
    assertThat(report.claim("Rest").orElseThrow().text())
        .isEqualTo("holds for 1 to 5 of PIDS; for more it is not decided");
  }

  @Test
  void stepThatBreaksAnInvariantIsShown() {
    Report report = proved(LOCK.replace("pre by = none", "pre true"));
    assertThat(report.isProved()).isFalse();
    assertThat(report.lines("x.starl"))
        .startsWith(
            "Lock: start is possible",
            "Lock: Holder is not kept by take",
            "  before  by = some(bot1), inside = {bot1}",
            "  action  take(bot0)",
            "  after   by = some(bot0)",
            "  fails   for i = bot1",
            "Lock: Alone stands only on Holder, not proved");
  }

  @Test
  void invariantThatNeedsAnotherOneAloneIsNotKept() {
    Report report = proved(LOCK.replaceAll("invariant Holder.*\n", ""));
    assertThat(report.claim("Alone").orElseThrow().verdict()).isEqualTo(Verdict.FAILED);
    assertThat(report.claim("Alone").orElseThrow().lines())
        .startsWith("before  by = some(bot0), inside = {bot1}", "action  enter(bot0)");
  }

  @Test
  void invariantThatTheStartBreaksIsShown() {
    Report report = proved(LOCK.replace("inside = {}", "true"));
    Claim alone = report.claim("Alone").orElseThrow();
    assertThat(alone.text()).isEqualTo("does not hold in a start state");
    assertThat(alone.lines())
        .containsExactly("state   inside = {bot0, bot1}", "fails   for i = bot0, j = bot1");
  }

  @Test
  void contradictoryStartIsTold() {
    Report report = proved(LOCK.replace("count = 0", "count = 0, by != none"));
    assertThat(report.isProved()).isFalse();
    assertThat(report.lines("x.starl"))
        .containsExactly("Lock: start contradicts itself: there is no start state");
  }

  @Test
  void actionThatNeverHappensIsTold() {
    Report report = proved(LOCK.replace("pre by = some(i)", "pre by = some(i), by = none"));
    assertThat(report.claim("Holder").orElseThrow().verdict()).isEqualTo(Verdict.PROVED);
    assertThat(report.claim("enter").orElseThrow().text()).isEqualTo("can never happen");
    assertThat(report.isProved()).isFalse();
  }

  @Test
  void numberBelowZeroIsTold() {
    Report report = proved(LOCK.replace(", count > 0", ""));
    assertThat(report.lines("x.starl"))
        .contains(
            "Lock: leave makes a number negative", "  after   by = none, inside = {}, count = -1");
    assertThat(report.claim("Holder").orElseThrow().isGood()).isFalse();
  }

  /** With few elements each quantifier is written out, so one operation is asked about more often, or not at all. */
  @Test
  void operationInAQuantifierIsShownWhereItHasNoValue() {
    assertThat(
            proved(
                    """
                    automaton Shares[PIDS]
                    state
                      m: [PIDS -> nat]
                    start forall i: PIDS :: m(i) = 0
                    action share(i: PIDS)
                      pre forall j: PIDS :: m(j) > 0 => 6 mod m(j) >= 0,
                          exists k, j: PIDS :: not k = j and 6 mod m(k) = 0
                      eff m(i) := 1
                    action find(i: PIDS)
                      pre (choose k: PIDS :: forall j: PIDS :: k = j) = i
                      eff m(i) := 2
                    """)
                .lines("x.starl"))
        .contains(
            "Shares: share has no value: a remainder by 0 or less",
            "  at x.starl:7:42",
            "  action  share(bot0)",
            "Shares: find has no value: nothing satisfies the condition of 'choose'",
            "  at x.starl:10:8",
            "  action  find(bot0)");
  }

  @Test
  void functionWhoseMeasureGrowsIsNotTrusted() {
    String endless = "fun f(n: nat): nat = f(n + 1) + 1 measure n\n";
    Report report = proved(LOCK + endless + "invariant Absurd: f(0) > f(0)\n");
    assertThat(report.lines("x.starl"))
        .startsWith(
            "Lock: f may not end: its measure may not become smaller", "  at x.starl:18:43");
    assertThat(report.claim("Absurd")).isEmpty();
    assertThat(report.isProved()).isFalse();
  }

  @Test
  void wrongInvariantOnARecursiveFunctionIsNotProved() {
    String sum = "fun sum(n: nat): nat = if n = 0 then 0 else sum(n - 1) + n measure n\n";
    String least = "invariant Sum: forall n: nat :: sum(n) >= n\n";
    assertThat(proved(LOCK + sum + least).isProved()).isTrue();
    Report wrong = proved(LOCK + sum + least.replace(">= n", "> n"));
    assertThat(wrong.claim("Sum").orElseThrow().isGood()).isFalse();
  }

  @Test
  void keptTextsSayWhatWasAsked() throws SourceErrors {
    Map<String, String> kept = new LinkedHashMap<>();
    Report first = new Prover(lock(LOCK), LIMIT, kept::put).prove();
    assertThat(kept.get("enter-keeps-Alone"))
        .contains(
            "; Holder holds", "; action enter(i: PIDS)", "(declare-fun s.by () (option PIDS))")
        .endsWith("(check-sat)\n");
    Map<String, String> again = new LinkedHashMap<>();
    assertThat(new Prover(lock(LOCK), LIMIT, again::put).prove()).isEqualTo(first);
    assertThat(again).isEqualTo(kept);
  }

  @Test
  void valuesThatAreKnownOfFewElementsAloneAreNoProofForAnyNumber() {
    String counted =
        """
        automaton Counted[P]
        state
          s: set[P]
          n: nat
        start s = {}, n = 0
        action put(p: P)
          eff s := s union {p}
        action count
          eff n := card({p: P | true}) - card(s)
        invariant Same: s subset s
        """;
    assertThat(proved(counted).lines("x.starl"))
        .contains(
            "Counted: Same holds for 1 to 5 of P; for more it is not decided",
            "Counted: count has values for 1 to 5 of P; for more it is not decided");
  }

  @Test
  void smallLimitDecidesNothing() throws SourceErrors {
    Report report = new Prover(lock(LOCK), 1, (name, text) -> {}).prove();
    assertThat(report.isProved()).isFalse();
    assertThat(report.claims()).extracting(Claim::verdict).containsOnly(Verdict.UNDECIDED);
  }

  @Test
  void typeThatIsNotTranslatedIsRefused() {
    assertThatThrownBy(() -> proved(LOCK.replace("count: nat", "count: nat log: option[set[nat]]")))
        .isInstanceOf(Unprovable.class)
        .hasMessageContaining("set[nat]");
  }

  @Test
  void aFunctionMayCallManyOthers() {
    StringBuilder chain = new StringBuilder(LOCK).append("fun f0: bool = count = count\n");
    for (int i = 1; i <= 200; i++) {
      chain.append("fun f" + i + ": bool = f" + (i - 1) + "\n");
    }
    assertThat(proved(chain + "invariant F: f200\n").isProved()).isTrue();
  }

  @ParameterizedTest
  @ValueSource(strings = {"TwoPhase", "LockServer", "Everybody"})
  void modelRefinesItsSpecification(String name) throws IOException, SourceErrors {
    Automaton automaton = new SourceReader().read(RefinementModels.file(name)).getLast();
    Report report = new Prover(automaton, LIMIT, (title, text) -> {}).prove();
    assertThat(report.claims()).extracting(Claim::verdict).containsOnly(Verdict.PROVED);
    String title = automaton.refinements().getFirst().title();
    String types = String.join(" and ", automaton.typeParameters());
    assertThat(report.lines("x.starl"))
        .contains(name + ": " + title + " holds, for any number of " + types);
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', textBlock = RefinementModels.MUTANTS)
  void mutantOfARefinementIsNotProved(String name, String from, String to, String action)
      throws IOException, SourceErrors {
    Automaton automaton = RefinementModels.mutant(name, from, to);
    Report report = new Prover(automaton, LIMIT, (title, text) -> {}).prove();
    Claim claim = report.claim(automaton.refinements().getFirst().title()).orElseThrow();
    assertThat(claim.verdict()).isEqualTo(Verdict.FAILED);
    assertThat(claim.lines()).anyMatch(line -> line.startsWith("action  "));
  }

  @Test
  void refinementIsToldByWhatFails() throws IOException, SourceErrors {
    String known = Files.readString(RefinementModels.file("TwoPhase"));
    String told = known.replace("chooseToAbort(r) is decideAbort(r),", "");
    assertThat(proved(told, "TwoPhase").lines("x.starl"))
        .containsSequence(
            "TwoPhase: Decided holds, for any number of RM",
            "TwoPhase: refinement tc is not kept by chooseToAbort",
            "  before  all empty, 0 or none",
            "  action  chooseToAbort(bot0)",
            "  after   rmState(bot0) = aborted",
            "  fails   for r = bot0");
    told = known.replace("if rmState(r) = prepared then decideCommit(r)", "decideCommit(r)");
    assertThat(proved(told, "TwoPhase").lines("x.starl"))
        .contains(
            "TwoPhase: refinement tc fails: learnCommit takes tc.decideCommit where it is not enabled",
            "  at x.starl:22:21",
            "  action  learnCommit(bot0)");
    told = known.replace("start forall r: RM :: rmState(r) = working,", "start");
    assertThat(proved(told, "TwoPhase").claim("refinement tc").orElseThrow().text())
        .isEqualTo("does not hold in a start state");
  }

  @Test
  void refinementThatIsNotTranslatedIsNotDecided() {
    String text =
        """
        automaton Log
        state last: option[set[nat]]
        start last = none
        action write
          eff last := some({1})
        automaton Switch
        state on: bool
        start not on
        refines log: Log by
          last := if on then some({1}) else none,
          turn is write
        action turn
          eff on := true
        invariant Any: on or not on
        """;
    assertThat(proved(text).lines("x.starl")).contains("Switch: Any holds");
    assertThat(proved(text).claim("refinement log").orElseThrow().text())
        .startsWith("is not decided: ")
        .contains("set[nat]");
  }

  private static Report proved(String text, String beside) throws SourceErrors {
    Automaton automaton =
        new SourceReader().look("x", text, RefinementModels.file(beside)).automata().getLast();
    return new Prover(automaton, LIMIT, (name, script) -> {}).prove();
  }

  private static Report proved(String text) {
    try {
      return new Prover(lock(text), LIMIT, (name, script) -> {}).prove();
    } catch (SourceErrors e) {
      throw new AssertionError(e);
    }
  }

  private static Automaton lock(String text) throws SourceErrors {
    List<Automaton> all = new SourceReader().read("lock.starl", text);
    return all.getLast();
  }
}
