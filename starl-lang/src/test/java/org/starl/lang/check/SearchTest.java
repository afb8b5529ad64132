package org.starl.lang.check;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Sizes;
import org.starl.lang.eval.TooLarge;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;

class SearchTest {

  private static final String MUTEX =
      """
      automaton Mutex[PIDS, Zones]
      state
        crit_set: [PIDS -> set[Zones]]
        req_set: [PIDS -> set[Zones]]
      start forall i: PIDS :: crit_set(i) = {} and req_set(i) = {}
      fun free_for?(i: PIDS, RS: set[Zones]): bool =
        forall j: PIDS :: not i = j => RS disjoint crit_set(j)
      action do_mutex(i: PIDS, RS: set[Zones])
        pre RS != {}, req_set(i) = {}, crit_set(i) = {}
        eff req_set(i) := RS
      action od_mutex(i: PIDS, RS: set[Zones])
        pre RS != {}, RS = req_set(i), free_for?(i, RS)
        eff crit_set(i) := RS, req_set(i) := {}
      action release(i: PIDS, RS: set[Zones])
        pre RS subset crit_set(i)
        eff crit_set(i) := crit_set(i) minus RS
      invariant Exclusive:
        forall i, j: PIDS :: not i = j => crit_set(i) disjoint crit_set(j)
      """;

  private static final String GROUP =
      MUTEX
          + """
          automaton Group[PIDS, Zones]
          state peers: [PIDS -> set[PIDS]]
          uses mux: Mutex[PIDS, Zones]
          start mux.start?, forall i: PIDS :: peers(i) = {}
          action do_mutex(i: PIDS, RS: set[Zones])
            pre mux.do_mutex(i, RS)
            eff mux.do_mutex(i, RS), peers(i) := {j: PIDS | not j = i}
          action od_mutex(i: PIDS)
            pre mux.req_set(i) != {},
              forall j: PIDS :: j in peers(i) => mux.req_set(i) disjoint mux.crit_set(j)
            eff mux.od_mutex(i, mux.req_set(i))
          """;

  private static final String CLOCK =
      """
      automaton Clock[PIDS]
      type Light = dark | lit(by: PIDS)
      state
        n: nat
        light: Light
        last: list[PIDS]
        who: option[PIDS]
        t: time
        m: [PIDS -> nat]
      start n = 0, light = dark, last = [], who = none, t = 0, forall i: PIDS :: m(i) = 0
      action tick eff n := n + 1
      action see(i: PIDS) pre n > 0 eff who := some(i)
      """;

  @Test
  void mutexIsExclusiveInEveryState() throws SourceErrors {
    Search.Result result = result(MUTEX, 3, true);
    assertThat(result.finding()).isEmpty();
    assertThat(result.isComplete()).isTrue();
    assertThat(result.symmetric()).containsExactly("PIDS", "Zones");
    assertThat(result.never()).isEmpty();
    assertThat(result.beyond()).isZero();
  }

  @Test
  void grantWithoutConditionIsToldByAShortestRun() throws SourceErrors {
    String broken = MUTEX.replace(", free_for?(i, RS)", "");
    for (boolean isSymmetric : new boolean[] {true, false}) {
      Finding finding = result(broken, 3, isSymmetric).finding().orElseThrow();
      assertThat(finding.name()).isEqualTo("Exclusive");
      assertThat(finding.steps()).isEqualTo(4);
      assertThat(finding.pos()).hasToString("18:37");
    }
    assertThat(lines(broken, 3))
        .startsWith(
            "Mutex (PIDS 3, Zones 2): Exclusive is false after 4 steps",
            "  1. do_mutex(bot0, {A})   req_set(bot0): {} -> {A}",
            "  2. do_mutex(bot1, {A})   req_set(bot1): {} -> {A}",
            "  3. od_mutex(bot0, {A})   crit_set(bot0): {} -> {A}, req_set(bot0): {A} -> {}",
            "  4. od_mutex(bot1, {A})   crit_set(bot1): {} -> {A}, req_set(bot1): {A} -> {}",
            "  file of Mutex:18:37: false for i = bot0, j = bot1");
  }

  @Test
  void stepOfAUsedAutomatonMustBeEnabledThere() throws SourceErrors {
    assertThat(result(GROUP, 2, true).finding()).isEmpty();
    String broken = GROUP.replace("{j: PIDS | not j = i}", "{}");
    assertThat(lines(broken, 2))
        .containsSubsequence(
            "Group (PIDS 2, Zones 2): a step is undefined after 3 steps",
            "  3. od_mutex(bot0)   mux.crit_set(bot0): {} -> {A}, mux.req_set(bot0): {A} -> {}",
            "  4. od_mutex(bot1)",
            "  file of Group:29:7: mux.od_mutex(bot1, {A}) is not enabled: 'free_for?(i, RS)' is false");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          who := some(the(who)) | 13:59: the(none) has no value
          who := some(head(last)) | 13:59: head([]) has no value
          last := tail(last) | 13:55: tail([]) has no value
          n := 1 - n | 13:52: 1 - 2 is below 0; expected a value of nat
          t := 1 / (n - 1) | 13:52: a division by 0
          who := some(light.by) | 13:59: 'by' of dark, which has no such field
          n := loop(n) | 14:25: calls of 'loop' nest deeper than 1,000; expected a measure that becomes smaller
          m(i) := 1, m(j) := 2 | 13:58: 'bad' changes one place twice; expected one effect on it
          """)
  void operationWithoutValueIsToldWithItsPlace(String effect, String told) throws SourceErrors {
    String more =
        "action bad(i, j: PIDS) pre n = 1 or n = 2 eff "
            + effect
            + "\nfun loop(k: nat): nat = loop(k) measure k\n";
    assertThat(lines(CLOCK + more, 2)).contains("  file of Clock:" + told);
  }

  @Test
  void numberBeyondTheBoundIsNotTaken() throws SourceErrors {
    Search.Result result = result(CLOCK, 2, false);
    assertThat(result.states()).isEqualTo(7); // n is 0, or 1 or 2 with one of three whos
    assertThat(result.beyond()).isEqualTo(3);
  }

  @Test
  void intsBelowTheBoundAreInstancesAndNoStates() throws SourceErrors {
    String ints =
        """
        automaton Ints[P]
        state
          z: int
          n: nat
        start z = 0 and n = 0
        action down eff z := n - 1
        action less eff z := z - 1
        action more eff z := z + 1
        invariant Least: exists i: int :: i < z
        invariant Most: exists i: int :: i > z and -i < z - 1
        """;
    Search.Result result = result(ints, 2, true);
    assertThat(result.states()).isEqualTo(5); // from -2 to 2
    assertThat(result.beyond()).isEqualTo(2);
    assertThat(result.unevaluated()).isEmpty();
    assertThat(result.finding()).isEmpty();
    String wrong = ints + "invariant Not: forall i: int :: i >= -3\n";
    assertThat(result(wrong, 2, true).finding().orElseThrow().name()).isEqualTo("Not");
  }

  @Test
  void invariantThatNeedsMoreThanTheBoundIsToldUnlessItIsFalse() throws SourceErrors {
    String invariant =
        """
        invariant Later: {k: nat | k >= n} != {}
        invariant Never: forall k: nat :: if k = 2 then n != 2 else {k2: nat | k2 >= n} != {}
        """;
    Search.Result result = result(CLOCK + invariant, 2, true);
    assertThat(result.unevaluated()).containsKey("Later");
    assertThat(result.finding().orElseThrow().name()).isEqualTo("Never");
  }

  @Test
  void recordsWithNumbersBeyondTheBoundAreAsked() throws SourceErrors {
    String records =
        """
        automaton Votes
        type Vote = record(r: nat, isFor: bool)
        state votes: set[Vote]
        start votes = {}
        action vote(v: Vote) pre not v in votes eff votes := votes union {v}
        invariant Known: forall v: Vote :: v in votes => v.r <= 2
        """;
    assertThat(result(records, 2, false).states()).isEqualTo(64);
  }

  @Test
  void actionsThatNeverHappenAndConjunctsThatAreNeverFalseAreTold() throws SourceErrors {
    String more = "action idle pre n > 2\naction on pre n >= 0, n > 1 eff n := 0\n";
    assertThat(lines(CLOCK + more, 2))
        .anyMatch(line -> line.endsWith("; never happens: idle"))
        .contains("  never false: 'n >= 0' of on")
        .noneMatch(line -> line.contains("'n > 1'"));
  }

  @Test
  void partsThatTheStartLeavesOpenAreTried() throws SourceErrors {
    Search.Result result = result(CLOCK.replace(", who = none", ""), 3, false);
    assertThat(result.open()).containsExactly("who");
    assertThat(result.states()).isEqualTo(12);
    String large = CLOCK.replace(", who = none", "").replace("option[PIDS]", "[set[PIDS] -> nat]");
    Search.Result first = result(large.replace("some(i)", "[S: set[PIDS] -> 0]"), 5, false);
    assertThat(first.cut()).containsExactly("who");
    assertThat(first.open()).isEmpty();
  }

  @Test
  void valueParametersAreTriedOrGiven() throws SourceErrors {
    String source = CLOCK.replace("Clock[PIDS]", "Clock[PIDS, some_of: set[PIDS]]");
    String bad = source + "invariant Few: not (n = 1 and forall i: PIDS :: i in some_of)\n";
    Finding finding = result(bad, 2, true).finding().orElseThrow();
    assertThat(finding.story())
        .containsExactly("0. start   some_of = {bot0, bot1}", "1. tick()   n: 0 -> 1");
    String large = source.replace("set[PIDS]]", "[set[PIDS] -> bool]]");
    assertThatThrownBy(() -> result(large, 5, true))
        .isInstanceOf(TooLarge.class)
        .hasMessageContaining("value parameter 'some_of': more than 100,000 values")
        .hasMessageContaining("--value 'some_of=...', of type [set[PIDS] -> bool]");
  }

  @Test
  void valueThatTheStartCopiesBeyondTheBoundIsTold() throws SourceErrors {
    String source =
        """
        automaton Copy[n: nat]
        state x: nat
        start x = n
        action down
          pre x > 0
          eff x := x - 1
        invariant Few: x <= 2
        """;
    assertThat(lines(source, 2).getFirst())
        .startsWith("Copy (n to --nat 2, --time 2): 6 states")
        .endsWith("Few holds");
    assertThat(lines(source.replace("x = n", "x = n + 1"), 2))
        .contains("  not each value is tried, but whole ones to --nat 2, --time 2: x at the start");
    assertThat(lines(source.replace("x = n", "x = n + 1, x <= 1"), 2))
        .noneMatch(line -> line.contains("not each value is tried"));
  }

  @Test
  void assumptionsAreAskedOfNumbersBeyondTheBound() throws SourceErrors {
    String source =
        """
        automaton More[n: nat]
        assume Some: exists m: nat :: m > n
        state c: nat
        start c = 0
        action stay
        invariant Zero: c = 0
        """;
    assertThat(lines(source, 2).getFirst()).startsWith("More (n to --nat 2, --time 2): 3 states");
    assertThat(
            lines(source.replace("exists m: nat :: m > n", "forall m: nat :: m <= n"), 2)
                .getFirst())
        .contains("0 states");
  }

  @Test
  void assumptionThatNeedsValuesBeyondTheBoundIsNotDecided() throws SourceErrors {
    String source =
        """
        automaton Less[f: [nat -> nat]]
        assume Down: forall n: nat :: f(n + 1) < f(n)
        state c: nat
        start c = 0
        action up
          eff c := 1
        invariant Few: c <= 1
        """;
    assertThat(lines(source, 2).getFirst()).contains("not decided: conditions are not evaluated");
    assertThat(lines(source, 2))
        .contains("  not evaluated: Down in 1 state, which need values beyond --nat 2, --time 2");
  }

  @Test
  void conditionOnNumbersOfMoreThan18DigitsIsNotDecided() throws SourceErrors {
    String source =
        """
        automaton Large
        state n: nat
        start n = 1
        action up
          pre n < 2
          eff n := n + 1
        invariant Some: n * 1000000000000 * 1000000000000 > 0
        """;
    assertThat(lines(source, 2).getFirst()).contains("not decided: conditions are not evaluated");
  }

  @Test
  void valuesThatBreakAnAssumptionAreNotTried() throws SourceErrors {
    String ride =
        """
        automaton Ride[PIDS, Places, way: [PIDS -> list[Places]]]
        assume Ways: forall i: PIDS :: way(i) != [] and distinct(way(i))
        state left: [PIDS -> list[Places]]
        start forall i: PIDS :: left(i) = way(i)
        action go(i: PIDS)
          pre left(i) != []
          eff left(i) := tail(left(i))
        invariant Once: forall i: PIDS :: distinct(left(i))
        """;
    Search.Result result = result(ride, 1, false);
    assertThat(result.finding()).isEmpty();
    assertThat(result.states()).isEqualTo(2 * 2 + 2 * 3); // [A], [B]; [A, B], [B, A]
    assertThat(result(ride.replace("and distinct(way(i))", ""), 1, false).finding()).isPresent();
  }

  @Test
  void stepOfAUsedAutomatonHappensOnlyIfItsConditionHolds() throws SourceErrors {
    String room =
        """
        automaton Lamp[PIDS]
        state on: set[PIDS]
        start on = {}
        action switch(i: PIDS)
          pre on = {}
          eff on := {i}
        automaton Room[PIDS]
        state dark: bool
        uses lamp: Lamp[PIDS]
        start lamp.start?, dark = true
        action enter(i: PIDS)
          eff if dark then lamp.switch(i), dark := false
        """;
    Search.Result result = result(room, 3, false);
    assertThat(result.finding()).isEmpty();
    assertThat(result.states()).isEqualTo(1 + 3);
    assertThat(result(room.replace("if dark then ", ""), 3, false).finding()).isPresent();
  }

  @Test
  void valueThatIsGivenIsTheOnlyOne() throws SourceErrors {
    String source = CLOCK.replace("Clock[PIDS]", "Clock[PIDS, some_of: set[PIDS]]");
    Automaton automaton = new SourceReader().read("x", source).getFirst();
    Sizes sizes = new Sizes(Map.of("PIDS", 2), 2, 2);
    Machine machine = new Machine(automaton, sizes);
    Object value =
        machine.value(
            SourceReader.readExpression(
                automaton,
                machine.elements(),
                automaton.valueParameters().getFirst().type(),
                "--value",
                "{bot1}"));
    Search search = new Search(machine, sizes, Map.of("some_of", value), false, 1000);
    assertThat(search.run().states()).isEqualTo(7);
    assertThat(search.visited()).allMatch(state -> state.get(0).equals(value));
  }

  @Test
  void searchThatDoesNotEndIsTold() throws SourceErrors {
    Automaton automaton = new SourceReader().read("x", MUTEX).getFirst();
    Sizes sizes = sizes(automaton, 3);
    Machine machine = new Machine(automaton, sizes);
    Search.Result result = new Search(machine, sizes, Map.of(), true, 5).run();
    assertThat(result.isComplete()).isFalse();
    assertThat(result.states()).isEqualTo(5);
    assertThat(Report.lines(automaton, sizes, result, name -> name).getFirst())
        .endsWith("THE SEARCH DID NOT END; nothing is wrong so far");
  }

  private static Sizes sizes(Automaton automaton, int robots) {
    Map<String, Integer> opaque = new LinkedHashMap<>();
    Machine.opaqueTypes(automaton).forEach(type -> opaque.put(type, opaque.isEmpty() ? robots : 2));
    return new Sizes(opaque, 2, 2);
  }

  static Search.Result result(String text, int robots, boolean isSymmetric) throws SourceErrors {
    Automaton automaton = new SourceReader().read("x.starl", text).getLast();
    Sizes sizes = sizes(automaton, robots);
    return new Search(new Machine(automaton, sizes), sizes, Map.of(), isSymmetric, 100_000).run();
  }

  static List<String> lines(String text, int robots) throws SourceErrors {
    Automaton automaton = new SourceReader().read("x.starl", text).getLast();
    Sizes sizes = sizes(automaton, robots);
    Search.Result result =
        new Search(new Machine(automaton, sizes), sizes, Map.of(), true, 100_000).run();
    return Report.lines(automaton, sizes, result, name -> "file of " + name);
  }
}
