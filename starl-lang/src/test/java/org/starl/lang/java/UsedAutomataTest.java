package org.starl.lang.java;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.math.BigInteger;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.lang.eval.Beyond;
import org.starl.lang.eval.EvalError;
import org.starl.lang.eval.Id;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Num;
import org.starl.lang.eval.Row;
import org.starl.lang.eval.Sizes;
import org.starl.lang.read.Source;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Action;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Type;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Sets;
import org.starl.spec.automaton.Term;
import org.starl.spec.automaton.Undefined;

/**
 * The Java of automata that use others, and what {@code starl check} explores of them, allow the same
 * actions on random runs, make the same of each, and have no value at the same places.
 *
 * <p>In Java an opaque type has no end. Here its last element occurs in no action.
 */
class UsedAutomataTest {

  private static final Path PVS = Path.of("..", "pvs", "starl");
  private static final int IDS = 3;
  private static final int NAT = 2;
  private static final int STEPS = 25;

  /** Two of one kind, below another one, with a parameter. */
  private static final String NESTED =
      """
      automaton Counter[T, most: nat]
      state count: [T -> nat]
      start forall t: T :: count(t) = 0
      fun full?(t: T): bool = count(t) = most
      fun over?(n: nat): bool = n > most
      fun one(n: nat): nat = n + 1
      fun before(t: T): nat = count(t) - 1
      action add(t: T) pre not full?(t) eff count(t) := one(count(t))
      action take(t: T) eff count(t) := before(t)
      action clear(t: T, u: T) pre t != u eff count(t) := 0, count(u) := 0

      automaton Pair[T, most: nat]
      uses a: Counter[T, most]
      uses b: Counter[T, most]
      start a.start?, b.start?
      fun empty?(t: T): bool = a.count(t) = 0 and b.count(t) = 0
      fun fits?(t: T): bool = a.add(t) and not b.full?(t)
      action add(t: T) pre fits?(t) eff a.add(t)
      action move(t: T) pre a.count(t) > 0, b.add(t) eff a.take(t), b.add(t)
      action both(t: T, u: T) eff a.add(t), if a.over?(a.one(b.count(u))) then b.clear(t, u)
      action lower(t: T) pre a.before(t) = b.count(t) eff a.take(t)

      automaton Top[T, most: nat]
      java "x.XAutomaton"
      uses pair: Pair[T, most]
      state
        seen: set[T]
        action_: nat
      start pair.start?, seen = {}, action_ = 0
      action add(t: T, u: T) pre pair.empty?(u) eff pair.add(t), seen := seen union {t}
      action move(t: T) eff if pair.a.count(t) > 0 then pair.move(t)
      action twice(t: T, u: T) pre u in seen eff pair.both(t, u), if t in seen then pair.move(t)
      action other(t: T) pre pair.a.count(t) > 0, pair.lower(t) eff pair.lower(t), seen := seen minus {t}
      action all pre (forall t: T :: t in seen => pair.move(t)), action_ < 2 eff action_ := action_ + 1
      action some pre exists t: T :: pair.move(t) eff action_ := 0
      action most_(t: T) pre forall u: T :: pair.fits?(u) or u = t or not pair.empty?(u) eff seen := {t}
      """;

  private record Value(Object explored, Object java) {}

  private final List<String> opaque = new ArrayList<>();

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4})
  void nestedOnesWithAParameterAgree(long seed) throws SourceErrors {
    Source source = new SourceReader().look("x.starl", NESTED, null);
    agree(source, Map.of("most", Num.of(seed % 2 + 1)), new Random(seed), 1);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void theMutexWithListsAgrees(long seed) throws IOException, SourceErrors {
    agree(published("Mutex_group_decls"), Map.of(), new Random(seed), 0);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2})
  void theIntersectionAgrees(long seed) throws IOException, SourceErrors {
    Row ab = Row.of(List.of(new Id(0), new Id(1)));
    Map<String, Object> given =
        Map.of(
            "Path",
            Row.of(List.of(ab, Row.of(List.of(new Id(1))))),
            "sd",
            Row.of(List.of(new Id(0), new Id(1), new Id(0))),
            "B",
            Num.of(1),
            "R",
            Num.of(1),
            "G",
            Num.of(2),
            "T",
            Num.of(1));
    agree(published("Traffic_decls"), given, new Random(seed), 0);
  }

  /** With strings as ids, so that what it uses has classes of its own beside it. */
  private static Source published(String name) throws IOException {
    String text =
        Files.readString(PVS.resolve(name + ".starl"))
            .replaceAll("(?m)^java .*\n", "")
            .replaceFirst("(?m)]$", "]\njava \"x.XAutomaton\"\njava time = \"long\"");
    return new SourceReader().look("x.starl", text, PVS.resolve("x.starl"));
  }

  private void agree(Source source, Map<String, Object> given, Random random, int undefined)
      throws SourceErrors {
    assertThat(source.errors()).isEmpty();
    Automaton automaton = source.automata().getLast();
    opaque.addAll(Machine.opaqueTypes(automaton));
    Map<String, Integer> sizes =
        opaque.stream().collect(Collectors.toMap(each -> each, each -> size(each)));
    Machine machine = new Machine(automaton, new Sizes(sizes, NAT, NAT));
    Object[] parameters =
        automaton.valueParameters().stream()
            .map(each -> java(each.type(), given.get(each.name())))
            .toArray();
    Compiled java = new Compiled(JavaSources.of(source, "x.starl"), parameters);
    String start = text(automaton, java.value());
    Row state =
        machine.starts(given).states().stream()
            .filter(each -> text(machine, each).equals(start))
            .findFirst()
            .orElseThrow(() -> new AssertionError("no start state is " + start));
    int taken = 0;
    int withoutValue = 0;
    int beyond = 0; // of the size: not known
    for (int step = 0; step < STEPS; step++) {
      List<Row> rows = new ArrayList<>();
      List<Object> states = new ArrayList<>();
      for (int number = 0; number < automaton.actions().size(); number++) {
        Action action = automaton.actions().get(number);
        for (List<Value> arguments : arguments(action)) {
          try {
            Row after = compared(machine, state, java, number, arguments);
            if (after != null) {
              rows.add(after);
              states.add(java.after(action.name(), java(arguments)));
              assertThat(text(automaton, states.getLast())).isEqualTo(text(machine, after));
            }
          } catch (EvalError e) {
            withoutValue++;
            assertThatThrownBy(() -> java.after(action.name(), java(arguments)))
                .as("%s%s in %s: %s", action.name(), arguments, text(machine, state), e)
                .isInstanceOf(Undefined.class);
          } catch (Beyond e) {
            beyond++;
          }
        }
      }
      if (rows.isEmpty()) {
        break;
      }
      int chosen = random.nextInt(rows.size());
      state = rows.get(chosen);
      java.go(states.get(chosen));
      taken++;
    }
    assertThat(taken).as("steps, and %d of the last states unknown", beyond).isGreaterThan(5);
    assertThat(withoutValue).isGreaterThanOrEqualTo(undefined);
  }

  /** The state after an action as it is explored; null if it is not enabled. */
  private static @Nullable Row compared(
      Machine machine, Row state, Compiled java, int number, List<Value> arguments) {
    String name = machine.name(number);
    List<Object> explored = arguments.stream().map(Value::explored).toList();
    boolean isEnabled = machine.firstFalse(state, number, explored).isEmpty();
    assertThat(java.enabled(name, java(arguments)).isTrue())
        .as("%s%s in %s", name, arguments, text(machine, state))
        .isEqualTo(isEnabled);
    return isEnabled ? machine.after(state, number, explored) : null;
  }

  private static Object[] java(List<Value> arguments) {
    return arguments.stream().map(Value::java).toArray();
  }

  private int size(String type) {
    return opaque.indexOf(type) == 0 ? IDS : IDS - 1;
  }

  private List<String> names(String type) {
    int place = opaque.indexOf(type);
    return IntStream.range(0, size(type))
        .mapToObj(i -> place == 0 ? "bot" + i : place == 1 ? "" + (char) ('A' + i) : type + i)
        .toList();
  }

  private List<List<Value>> arguments(Action action) {
    List<List<Value>> all = List.of(List.of());
    for (Type.Field parameter : action.parameters()) {
      List<Value> values = values(parameter.type().base());
      all =
          all.stream()
              .flatMap(before ->
                  values.stream()
                      .map(each -> Stream.concat(before.stream(), Stream.of(each)).toList()))
              .toList();
    }
    return all;
  }

  private List<Value> values(Type type) {
    return switch (type) {
      case Type.Opaque of ->
          IntStream.range(0, IDS - 1)
              .mapToObj(i -> new Value(new Id(i), names(of.name()).get(i)))
              .toList();
      case Type.SetOf set -> {
        List<Value> elements = values(set.element());
        yield IntStream.range(0, 1 << elements.size())
            .mapToObj(bits -> new Value(BigInteger.valueOf(bits), chosen(elements, bits)))
            .toList();
      }
      default ->
          IntStream.rangeClosed(0, NAT).mapToObj(i -> new Value(Num.of(i), (long) i)).toList();
    };
  }

  private static Object chosen(List<Value> of, int bits) {
    return Sets.of(
        IntStream.range(0, of.size())
            .filter(i -> (bits >> i & 1) == 1)
            .mapToObj(i -> of.get(i).java())
            .toList());
  }

  /** A parameter's value. */
  private Object java(Type type, Object explored) {
    return switch (type.base()) {
      case Type.Opaque of -> names(of.name()).get(((Id) explored).number());
      case Type.ListOf list ->
          IntStream.range(0, ((Row) explored).size())
              .mapToObj(i -> java(list.element(), ((Row) explored).get(i)))
              .toList();
      case Type.MapOf map -> {
        List<String> keys = names(((Type.Opaque) map.arguments().getFirst().base()).name());
        Function<Object, Object> function =
            key -> java(map.result(), ((Row) explored).get(keys.indexOf(key)));
        yield function;
      }
      default -> ((Num) explored).over();
    };
  }

  private static String text(Machine machine, Row state) {
    return IntStream.range(machine.parameters().size(), machine.parts().size())
        .mapToObj(i -> machine.parts().get(i).domain().text(state.get(i)))
        .collect(Collectors.joining("; "));
  }

  private String text(Automaton automaton, Object state) {
    return automaton.state().stream()
        .map(each -> text(each.type().base(), RandomAutomataTest.field(state, each.name())))
        .collect(Collectors.joining("; "));
  }

  private String text(Type type, Object value) {
    return switch (type.base()) {
      case Type.StateOf used ->
          used.automaton().state().stream()
              .map(each ->
                  each.name()
                      + " := "
                      + text(each.type(), RandomAutomataTest.field(value, each.name())))
              .collect(Collectors.joining(", ", type + "(", ")"));
      case Type.SetOf set -> texts(set.element(), value, "{", "}");
      case Type.ListOf list -> texts(list.element(), value, "[", "]");
      case Type.MapOf map ->
          keys(map.arguments().getFirst()).stream()
              .map(key -> key + " -> " + text(map.result(), ((Fun<?, ?>) value).at(cast(key))))
              .collect(Collectors.joining(", ", "[", "]"));
      case Type.Sum sum -> value instanceof Term term ? term.text() : value.toString();
      default -> value.toString();
    };
  }

  @SuppressWarnings("unchecked") // the map's arguments are of this type
  private static <K> K cast(Object key) {
    return (K) key;
  }

  private List<?> keys(Type of) {
    return of.base() instanceof Type.Opaque type
        ? names(type.name())
        : IntStream.rangeClosed(0, NAT).mapToObj(i -> (long) i).toList();
  }

  private String texts(Type element, Object values, String begin, String end) {
    return ((Collection<?>) values)
        .stream().map(each -> text(element, each)).collect(Collectors.joining(", ", begin, end));
  }

  @Test
  void aFalseStepIsToldWithWhatMakesItFalse() throws SourceErrors {
    Compiled top = new Compiled(NESTED, 1);
    assertThat(top.enabled("all").isTrue()).isTrue();
    top.step("add", "t", "t");
    top.step("move", "t");
    assertThat(top.enabled("all").falseConjunct())
        .isEqualTo(
            "(forall t: T :: t in seen => pair.move(t)) is false:"
                + " t = t, seen = [t], a.count(t) > 0 is false: a.count(t) = 0");
    assertThatThrownBy(() -> top.step("twice", "t", "t"))
        .isInstanceOf(Undefined.class)
        .hasMessageStartingWith("x.starl:20:39: b.clear(t, t) is not enabled: t != u is false");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          java PIDS = "Long" | java PIDS = "Long" | y/XAutomaton.java, y/XAction.java
          java PIDS = "Long" |  | y/XAutomaton.java, y/XAction.java, y/XLampAutomaton.java, y/XLampAction.java
          java PIDS = "Long" | java PIDS = "String" | y/XAutomaton.java, y/XAction.java, y/XLampAutomaton.java, y/XLampAction.java
           |  | y/XAutomaton.java, y/XAction.java
          """)
  void aUsedOneHasTheClassThatItNamesIfTheTypesAreTheSame(String lamp, String room, String expected)
      throws SourceErrors {
    String text =
        """
        automaton Lamp[PIDS]
        java "x.LampAutomaton"
        LAMP
        state isOn: bool
        start isOn = false
        action on(i: PIDS) pre not isOn eff isOn := true
        automaton Room[PIDS]
        java "y.XAutomaton"
        ROOM
        uses lamp: Lamp[PIDS]
        start lamp.start?
        action go(i: PIDS) pre lamp.on(i) eff lamp.on(i)
        """
            .replace("LAMP", lamp == null ? "" : lamp)
            .replace("ROOM", room == null ? "" : room);
    Map<String, String> files =
        JavaSources.of(new SourceReader().read("x.starl", text).getLast(), "x.starl");
    assertThat(files.keySet()).containsExactlyInAnyOrder(expected.split(", "));
  }

  @Test
  void aComponentWithValuesOfItsOwnAtTheStartIsNotAskedForAllArguments() {
    assertThatThrownBy(() ->
            Compiled.files(
                """
                automaton Own[T, of: [T -> nat]]
                java "x.XAutomaton"
                state n: [T -> nat]
                start forall t: T :: n(t) = of(t)
                action zero pre forall t: T :: n(t) = 0
                """))
        .isInstanceOf(SourceErrors.class)
        .hasMessageStartingWith(
            "x.starl:5:32: each argument has a value of its own at the start; expected");
  }
}
