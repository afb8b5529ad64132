package org.starl.lang.java;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.lang.read.SourceErrors;
import org.starl.spec.automaton.Undefined;

class JavaSourcesTest {

  private static final String PAIR =
      """
      automaton Pair[T]
      java "x.XAutomaton"
      type Color = red | green
      type Both = record(left: nat, right: option[T])
      type Form = none_yet | some_of(those: set[T]) | one(it: T, at: nat)
      state
        a: nat
        b: nat
        color: Color
        both: [T -> Both]
        form: Form
        grid: [T, nat -> nat]
        queue: list[T]
      start a = 1, b = 2, color = green, forall t: T :: both(t).left = 3, queue = []
      fun sum(n: nat): nat = if n = 0 then 0 else n + sum(n - 1) measure n
      fun size(f: Form): nat = match f { none_yet -> 0, some_of(S) -> if S = {} then 1 else 2, one(t, n) -> n }
      action swap eff a := b, b := a
      action paint pre color is red eff color := if color = green then red else green
      action set_right(t: T) eff both(t).right := some(t), grid(t, a) := b, grid(t, b) := a
      action same(t: T, u: T) pre both(t).right != none, the(both(t).right) = u
      action forms(f: Form) pre size(f) > 1 eff form := f
      action sums(n: nat, m: nat) pre sum(n) = m
      action equal(n: nat, m: nat) pre n = m, (n < m) <=> (m < n)
      action queued(t: T) pre queue != [], head(queue) = t eff queue := tail(queue)
      action enqueue(t: T) eff queue := [t, t]
      """;

  private static Compiled pair;

  @BeforeAll
  static void compile() throws SourceErrors {
    pair = new Compiled(PAIR);
  }

  @BeforeEach
  void begin() {
    pair.begin();
  }

  @Test
  void startHasWhatIsAskedAndTheFirstValueElsewhere() {
    assertThat(pair.state())
        .isEqualTo("States[a=1, b=2, color=green, both=(), form=none_yet, grid=(), queue=[]]");
  }

  @Test
  void effectsReadTheStateBefore() {
    assertThat(pair.step("swap")).contains("a=2, b=1");
  }

  @Test
  void effectsChangeFieldsAndPointsOfMaps() {
    assertThat(pair.step("set_right", "t"))
        .contains("both=(t: Both[left=3, right=up(t)])", "grid=(t: (1: 2, 2: 1))");
  }

  @Test
  void falseConjunctsAreNamedByTheirTextWithTheirValues() {
    assertThat(pair.enabled("paint").falseConjunct())
        .isEqualTo("color is red is false: color = green");
    assertThat(pair.enabled("sums", 3L, 7L).falseConjunct())
        .isEqualTo("sum(n) = m is false: sum(3) = 6");
    assertThat(pair.enabled("sums", 3L, 6L).isTrue()).isTrue();
  }

  @Test
  void allValuesThatMakeAConditionFalseAreNamed() throws SourceErrors {
    Compiled asks =
        new Compiled(
            """
            automaton Asks[T]
            java "x.XAutomaton"
            state
              has: set[T]
              gets: set[T]
              known: set[T]
            start has = {}, gets = {}, known = {}
            action put(t: T) eff has := has union {t}
            action ask pre forall t: T :: t in has or t in gets => t in known
            """);
    asks.step("put", "t");
    assertThat(asks.enabled("ask").falseConjunct())
        .isEqualTo(
            "forall t: T :: t in has or t in gets => t in known is false:"
                + " t = t, has = [t], known = []");
  }

  @Test
  void functionsMayHaveTheNamesOfMethodsThatChangeOneComponent() throws SourceErrors {
    Compiled six =
        new Compiled(
            """
            automaton Six
            java "x.XAutomaton"
            state
              a: nat
              b: nat
              c: nat
              d: nat
              e: nat
              f: nat
            start a = 0
            fun with_a(n: nat): nat = a + n
            action add(n: nat) eff a := with_a(n)
            """);
    assertThat(six.step("add", 2L)).isEqualTo("States[a=2, b=0, c=0, d=0, e=0, f=0]");
  }

  @Test
  void argumentsThatArePrimitiveAreCompared() {
    assertThat(pair.enabled("equal", 300L, 300L).isTrue()).isTrue();
    assertThat(pair.enabled("equal", 300L, 301L).falseConjunct())
        .isEqualTo("n = m is false: n = 300, m = 301");
  }

  @Test
  void conjunctsMayNeedThoseBefore() {
    assertThat(pair.enabled("same", "t", "t").falseConjunct())
        .startsWith("both(t).right != none is false");
    assertThat(pair.enabled("queued", "t").falseConjunct()).startsWith("queue != [] is false");
    pair.step("set_right", "t");
    assertThat(pair.enabled("same", "t", "t").isTrue()).isTrue();
    assertThat(pair.enabled("same", "t", "u").falseConjunct())
        .isEqualTo("the(both(t).right) = u is false: both(t).right = up(t)");
    pair.step("enqueue", "t");
    assertThat(pair.enabled("queued", "t").isTrue()).isTrue();
    assertThat(pair.step("queued", "t")).contains("queue=[t]");
  }

  @Test
  void functionsThatCountDownAreLoops() {
    assertThat(pair.enabled("sums", 1_000_000L, 500_000_500_000L).isTrue()).isTrue();
  }

  @Test
  void matchTakesTheCaseOfTheValue() throws ReflectiveOperationException {
    assertThat(pair.enabled("forms", form("none_yet")).isTrue()).isFalse();
    assertThat(pair.enabled("forms", form("some_of", new TreeSet<>())).isTrue()).isFalse();
    SortedSet<String> one = new TreeSet<>(List.of("t"));
    assertThat(pair.enabled("forms", form("some_of", one)).isTrue()).isTrue();
    assertThat(pair.enabled("forms", form("one", "t", 1L)).isTrue()).isFalse();
    assertThat(pair.enabled("forms", form("one", "t", 2L)).isTrue()).isTrue();
    assertThat(pair.step("forms", form("one", "t", 2L))).contains("form=one(t, 2)");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          n := n - 1 | 14:20: 0 - 1 is below 0
          n := before(n) | 13:27: 0 - 1 is below 0
          """)
  void whatHasNoValueIsToldWithItsPlace(String effect, String told) throws SourceErrors {
    String text =
        """
        automaton Partial[T]
        java "x.XAutomaton"
        java time = "double"
        type Form = none_yet | one(at: nat)
        state
          n: nat
          w: time
          t: T
          o: option[nat]
          l: list[T]
          f: Form
        start n = 0, w = 0, o = none, l = [], f = none_yet
        fun before(m: nat): nat = m - 1
        action go eff EFFECT
        action off pre n > 0 eff EFFECT
        action looked pre n > 0, before(n) = 1, n - 1 = 1
        """;
    Compiled partial = new Compiled(text.replace("EFFECT", effect));
    assertThatThrownBy(() -> partial.step("go"))
        .isInstanceOf(Undefined.class)
        .hasMessage("x.starl:" + told);
    // A replay takes actions that are not enabled, too.
    assertThat(partial.step("off")).isEqualTo(partial.state());
    assertThat(partial.enabled("looked").falseConjunct()).isEqualTo("n > 0 is false: n = 0");
  }

  @Test
  void quantifiersDoNotAskForValuesThatTheConditionBeforeExcludes() throws SourceErrors {
    Compiled partial =
        new Compiled(
            """
            automaton Tried[T]
            java "x.XAutomaton"
            state
              n: nat
              o: option[T]
              m: [T -> nat]
              k: option[nat]
            start n = 0, o = none, k = none, forall t: T :: m(t) = 0
            action all pre forall t: T :: o != none and n = 0 => t != the(o) eff n := 1
            action some pre exists t: T :: (o = none or t = the(o)) and (not k != none or m(t) = the(k)) eff n := 1
            action bare pre forall t: T :: t = the(o) => m(t) = 0 eff n := 1
            action put(t: T) eff o := some(t), k := some(0)
            """);
    assertThat(partial.enabled("all").isTrue()).isTrue();
    assertThat(partial.enabled("some").isTrue()).isTrue();
    assertThatThrownBy(() -> partial.enabled("bare"))
        .isInstanceOf(Undefined.class)
        .hasMessage("x.starl:11:36: the(none) has no value");
    partial.step("put", "t");
    assertThat(partial.enabled("all").isTrue()).isFalse();
    assertThat(partial.enabled("some").isTrue()).isTrue();
    assertThat(partial.enabled("bare").isTrue()).isTrue();
  }

  @Test
  void twoChangesOfOnePlaceAreToldWithTheLaterOne() throws SourceErrors {
    Compiled twice =
        new Compiled(
            """
            automaton Twice[T]
            java "x.XAutomaton"
            type Both = record(left: nat, right: nat)
            state
              n: nat
              m: [T -> nat]
              b: Both
            start n = 0
            action places(t: T, u: T, k: nat) eff m(t) := 1, m(u) := k
            action fields(k: nat) eff b.left := k, b.right := 1
            action off(t: T, u: T) pre n > 0 eff m(t) := 2, m(u) := 1
            """);
    assertThat(twice.after("places", "t", "u", 2L).toString()).contains("m=(t: 1, u: 2)");
    assertThat(twice.after("places", "t", "t", 1L).toString()).contains("m=(t: 1)");
    assertThat(twice.after("fields", 2L).toString()).contains("b=Both[left=2, right=1]");
    assertThat(twice.after("off", "t", "t").toString()).contains("m=(t: 1)");
    assertThatThrownBy(() -> twice.after("places", "t", "t", 2L))
        .isInstanceOf(Undefined.class)
        .hasMessage("x.starl:9:50: 'places' changes one place twice; expected one effect on it");
  }

  private Object form(String constructor, Object... arguments) throws ReflectiveOperationException {
    Class<?> type = pair.loader().loadClass("x.XAutomaton$Form$" + constructor);
    var made = type.getDeclaredConstructors()[0];
    made.setAccessible(true);
    return made.newInstance(arguments);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          a: nat | a: time | 1:1: no Java type is given for time; expected a line: java time = "long", or "double"
          eff S := {t} | eff S := {u: T ∣ not u = t} | 8:27: this set may be infinite; expected a condition on finitely many values, or a line: java set[T] = "org.starl.spec.automaton.Fun"
          pre t in S | pre forall n: nat :: n < a => t in S | 7:40: the values of 'n' that matter here are not known to be finitely many; expected n to be compared, looked up in a set, or the argument of a map
          start a = 0 | start a > 0 | 6:7: no start state is found from this condition; expected equations such as 'owner = none', or 'forall i: PIDS :: held(i) = {}'
          start a = 0 | start a = 0, a = 1 | 6:14: the start state has two values here; expected one
          java "x.XAutomaton" | java "XAutomaton" | 1:1: 'XAutomaton' is no Java class of an automaton; expected a line: java "a.package.NameAutomaton"
          java "x.XAutomaton" |  | 1:1: automaton 'Small' names no Java class; expected a line: java "a.package.NameAutomaton"
          """)
  void whatHasNoFormIsToldWithItsPlace(String right, String wrong, String error) {
    String text =
        """
        automaton Small[T]
        java "x.XAutomaton"
        state
          a: nat
          S: set[T]
        start a = 0
        action take(t: T) pre t in S
        action put(t: T) eff S := {t}
        """;
    String changed = text.replace(right, wrong == null ? "" : wrong.replace('∣', '|'));
    assertThatThrownBy(() -> Compiled.files(changed))
        .isInstanceOf(SourceErrors.class)
        .hasMessage("x.starl:" + error);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "class",
        "var",
        "record",
        "States",
        "Action",
        "Term",
        "Fun",
        "Lift",
        "List",
        "Override",
        "String",
        "Object",
        "Undefined",
        "Finite",
        "Sets",
        "SortedSet",
        "Long",
        "XAutomaton",
        "XAction"
      })
  void aTypeMayHaveAnyName(String name) throws SourceErrors {
    String body =
        """
        automaton Named[T]
        java "x.XAutomaton"
        type NAME = FORMS
        state
          x: NAME
          m: [T -> NAME]
          l: list[NAME]
          o: option[NAME]
          q: nat
        start q = 0, l = [], o = none
        action put(t: T, v: NAME)
          pre q < 3, m(t) = x
          eff m(t) := v, x := v, l := l ++ [v], o := some(v), q := q + 1
        action get
          pre l != []
          eff x := head(l), l := tail(l), q := 3 - q
        invariant Known: elements(l) subset elements(l)
        """
            .replace("NAME", name);
    for (String forms : List.of("aa | bb", "aa | bb(n: nat)", "record(n: nat, k: set[nat])")) {
      assertThat(new Compiled(body.replace("FORMS", forms)).state()).contains("q=0");
    }
  }

  @Test
  void anyValuesAreElementsOfSetsAndFormsAreArgumentsOfMaps()
      throws SourceErrors, ReflectiveOperationException {
    Compiled compiled =
        new Compiled(
            """
            automaton Keys[T]
            java "x.XAutomaton"
            type Pair = record(that: nat, who: T)
            type Form = Form(n: nat) | empty
            state
              pairs: set[Pair]
              forms: set[Form]
              options: set[option[Form]]
              sets: set[set[Pair]]
              of: [Pair -> nat]
              by: [Form -> nat]
            start pairs = {}, forms = {}, options = {}, sets = {}, forall p: Pair, f: Form :: of(p) = 0 and by(f) = 0
            action put(n: nat, t: T)
              eff pairs := pairs union {Pair(n, t)}, forms := forms union {Form(n), empty},
                options := options union {some(Form(n)), none}, sets := sets union {pairs},
                of(Pair(n, t)) := n, by(Form(n)) := n
            action seen(n: nat, t: T)
              pre Pair(n, t) in pairs, Form(n) in forms, none in options, {} in sets, of(Pair(n, t)) = n,
                by(Form(n)) = n
            """
                .replace("Pair(n, t)", "Pair(that := n, who := t)"));
    compiled.step("put", 2L, "p");
    compiled.step("put", 1L, "q");
    assertThat(compiled.enabled("seen", 2L, "p").isTrue()).isTrue();
    assertThat(compiled.enabled("seen", 1L, "q").isTrue()).isTrue();
    assertThat(compiled.enabled("seen", 1L, "p").isTrue()).isFalse();
  }
}
