package org.starl.lang.java;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.BiPredicate;
import java.util.stream.Stream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;
import org.junit.jupiter.api.Test;
import org.starl.lang.read.SourceErrors;

/** Conditions on all values are as on a universe that has more values than the state mentions. */
class QuantifiersTest {

  private static final List<String> NAMES = List.of("p", "q", "r");
  // The first value of T is empty; y and z occur nowhere.
  private static final List<String> UNIVERSE = List.of("", "p", "q", "r", "y", "z");
  private static final int CONDITIONS = 40;

  /** A state, and the arguments of an action. */
  private record Here(TreeSet<String> those, Map<String, String> next, String me) {
    private String nextOf(String name) {
      return next.getOrDefault(name, "");
    }
  }

  /** A condition on {@code x}: its text, and its value. */
  private record Condition(String text, BiPredicate<String, Here> value) {}

  @Test
  void aSetMayHaveTheVariableItself() throws SourceErrors {
    Compiled compiled =
        new Compiled(
            """
            automaton Random_decls[T]
            java "x.XAutomaton"
            state
              those: set[T]
            start those = {}
            action self(me: T) pre forall x: T :: x in {x}
            action mine(me: T) pre exists x: T :: me in {x}
            action yours(me: T) pre exists x: T :: x != me and me in {x}
            """);
    assertThat(compiled.enabled("self", "q").isTrue()).isTrue();
    assertThat(compiled.enabled("mine", "q").isTrue()).isTrue();
    assertThat(compiled.enabled("yours", "q").isTrue()).isFalse();
  }

  @Test
  void allValuesOfAFiniteTypeAreTried() throws SourceErrors, ReflectiveOperationException {
    Compiled compiled =
        new Compiled(
            """
            automaton Random_decls[T]
            java "x.XAutomaton"
            type Color = red | green
            type Pair = record(so: bool, of: Color)
            state
              those: set[Pair]
              ways: [Color, bool -> nat]
            start those = {}, forall c: Color, b: bool :: ways(c, b) = 0
            action count(c: Color, b: bool) eff ways(c, b) := 1
            action even pre ways = [c: Color, b: bool -> 1]
            action put(b: bool) eff those := those union {Pair(so := b, of := green)}
            action any pre exists b: bool, c: Color :: Pair(so := b, of := c) in those
            action all pre forall b: bool :: Pair(so := b, of := green) in those
            """);
    Object[] colors = compiled.enumerated("Color");
    for (Object color : colors) {
      compiled.step("count", color, true);
      assertThat(compiled.enabled("even").isTrue()).isFalse();
      compiled.step("count", color, false);
    }
    assertThat(compiled.enabled("even").isTrue()).isTrue();
    assertThat(compiled.enabled("any").isTrue()).isFalse();
    compiled.step("put", true);
    assertThat(compiled.enabled("any").isTrue()).isTrue();
    assertThat(compiled.enabled("all").isTrue()).isFalse();
    compiled.step("put", false);
    assertThat(compiled.enabled("all").isTrue()).isTrue();
  }

  @Test
  void aNaturalNumberIsNeverNegative() throws SourceErrors {
    Compiled compiled =
        new Compiled(
            """
            automaton Random_decls[T]
            java "x.XAutomaton"
            java real = "double"
            java time = "double"
            state
              z: int
              x: real
              ints: set[int]
              at: [int -> bool]
              nats: set[nat]
              places: [nat -> bool]
            start z = -1, x = -0.5, ints = {-2}, forall i: int :: not at(i), nats = {},
              forall n: nat :: not places(n)
            action mark(i: int) eff at(i) := true
            action same pre exists k: nat :: k <= 3 and k = z
            action differs pre forall k: nat :: k != z
            action contained pre exists k: nat :: k in ints
            action ranged pre exists k: nat :: z <= k and k <= -1
            action within pre exists k: nat :: k in -3..z
            action marked pre exists k: nat :: at(k)
            action looked pre exists k: nat :: not (k in ints => k = 5)
            action timed pre exists t: time :: t = x
            action gather eff nats := {k: nat | k = z}
            action gathered pre nats = {}
            action place eff places := [k: nat -> if k = z then true else places(k)]
            action placed pre places = [k: nat -> false]
            """);
    compiled.step("mark", -3L);
    compiled.step("gather");
    compiled.step("place");
    assertThat(
            Stream.of("same", "contained", "ranged", "within", "marked", "looked", "timed")
                .filter(each -> compiled.enabled(each).isTrue()))
        .isEmpty();
    assertThat(
            Stream.of("differs", "gathered", "placed")
                .filter(each -> !compiled.enabled(each).isTrue()))
        .isEmpty();
  }

  @Test
  void wholeNumbersAreNotSoughtAmongOthers() {
    assertThatThrownBy(() ->
            Compiled.files(
                """
                automaton Random_decls
                java "x.XAutomaton"
                java real = "double"
                state x: real
                start x = 0.5
                action found pre exists k: nat :: k = x
                """))
        .hasMessageContaining(
            "x.starl:6:35: a whole number is sought among values of real; expected an int");
  }

  @Property(tries = 6)
  @Tag("long")
  void generatedConditionsAreTrueWhereTheyAreInAFiniteUniverse(@ForAll long seed)
      throws SourceErrors {
    Random random = new Random(seed);
    List<Condition> conditions = new ArrayList<>();
    StringBuilder text =
        new StringBuilder(
            """
            automaton Random_decls[T]
            java "x.XAutomaton"
            state
              those: set[T]
              next: [T -> T]
            start those = {}
            fun follows?(t: T, u: T): bool = next(t) = u or next(u) = t
            action put(t: T) eff those := those union {t}
            action point(t: T, u: T) eff next(t) := u
            """);
    for (int n = 0; n < CONDITIONS; n++) {
      Condition condition = any(random, 3);
      conditions.add(condition);
      text.append("action all_%d(me: T) pre forall x: T :: %s\n".formatted(n, condition.text));
      text.append("action one_%d(me: T) pre exists x: T :: %s\n".formatted(n, condition.text));
      text.append(
          "action map_%d(me: T) eff next := [x: T -> if %s then me else next(x)]\n"
              .formatted(n, condition.text));
    }
    Compiled compiled = new Compiled(text.toString());
    Here here = new Here(new TreeSet<>(), new TreeMap<>(), "q");
    for (int change = 0; change < 5; change++) {
      for (int n = 0; n < CONDITIONS; n++) {
        Condition each = conditions.get(n);
        assertThat(compiled.enabled("all_" + n, "q").isTrue())
            .as("all: %s in %s", each.text, here)
            .isEqualTo(UNIVERSE.stream().allMatch(x -> each.value.test(x, here)));
        assertThat(compiled.enabled("one_" + n, "q").isTrue())
            .as("one: %s in %s", each.text, here)
            .isEqualTo(UNIVERSE.stream().anyMatch(x -> each.value.test(x, here)));
        compiled.enabled("all_" + n, "q").falseConjunct();
      }
      int changed = random.nextInt(CONDITIONS);
      compiled.step("map_" + changed, "q");
      Map<String, String> next = new TreeMap<>();
      for (String x : UNIVERSE) {
        next.put(x, conditions.get(changed).value.test(x, here) ? here.me : here.nextOf(x));
      }
      here.next.putAll(next);
      String a = NAMES.get(random.nextInt(NAMES.size()));
      String b = NAMES.get(random.nextInt(NAMES.size()));
      if (random.nextBoolean()) {
        compiled.step("put", a);
        here.those.add(a);
      } else {
        compiled.step("point", a, b);
        here.next.put(a, b);
      }
    }
  }

  private static Condition any(Random random, int depth) {
    if (depth == 0 || random.nextInt(4) == 0) {
      return atom(random);
    }
    Condition a = any(random, depth - 1);
    Condition b = any(random, depth - 1);
    return switch (random.nextInt(4)) {
      case 0 -> new Condition("not (" + a.text + ")", a.value.negate());
      case 1 -> new Condition("(" + a.text + ") and (" + b.text + ")", a.value.and(b.value));
      case 2 -> new Condition("(" + a.text + ") or (" + b.text + ")", a.value.or(b.value));
      default ->
          new Condition("(" + a.text + ") => (" + b.text + ")", a.value.negate().or(b.value));
    };
  }

  private static Condition atom(Random random) {
    return switch (random.nextInt(7)) {
      case 0 -> new Condition("x in those", (x, s) -> s.those.contains(x));
      case 1 -> new Condition("x = me", (x, s) -> x.equals(s.me));
      case 2 -> new Condition("next(x) = me", (x, s) -> s.nextOf(x).equals(s.me));
      case 3 -> new Condition("next(x) in those", (x, s) -> s.those.contains(s.nextOf(x)));
      case 4 ->
          new Condition(
              "x in {me, next(me)}", (x, s) -> x.equals(s.me) || x.equals(s.nextOf(s.me)));
      case 5 ->
          new Condition(
              "follows?(x, me)", (x, s) -> s.nextOf(x).equals(s.me) || s.nextOf(s.me).equals(x));
      default -> new Condition("next(x) = next(me)", (x, s) -> s.nextOf(x).equals(s.nextOf(s.me)));
    };
  }
}
