package org.starl.lang.java;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.BiConsumer;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.ShrinkingMode;
import net.jqwik.api.Tag;
import org.starl.lang.eval.Beyond;
import org.starl.lang.eval.Id;
import org.starl.lang.eval.Machine;
import org.starl.lang.eval.Num;
import org.starl.lang.eval.Row;
import org.starl.lang.eval.Sizes;
import org.starl.lang.read.SourceErrors;
import org.starl.lang.read.SourceReader;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Type;
import org.starl.spec.automaton.Fun;
import org.starl.spec.automaton.Lift;
import org.starl.spec.automaton.Term;

/**
 * The Java of a random automaton, and what {@code starl check} explores of it, allow the same
 * actions and make the same of each.
 *
 * <p>In Java a type of ids has no end. Here it has two ids that actions name, and two that occur
 * nowhere: conditions with up to two variables cannot tell more apart.
 */
class RandomAutomataTest {

  private static final int ACTIONS = 12;
  private static final int STEPS = 15;
  private static final int NAT = 5;
  static final List<String> IDS = List.of("bot0", "bot1", "bot2", "bot3");

  /** A call, as Java and as the machine have its arguments. */
  record Call(int action, Object[] java, List<Object> arguments) {}

  /** What a state's calls are, and the states that they lead to, as the machine and Java have them. */
  record Steps(
      List<Call> enabled,
      List<Call> disabled,
      List<Call> beyond,
      List<Row> rows,
      List<Object> java) {
    Steps() {
      this(
          new ArrayList<>(),
          new ArrayList<>(),
          new ArrayList<>(),
          new ArrayList<>(),
          new ArrayList<>());
    }
  }

  @Example
  void aConditionOnAValueThatVariesHasNoJavaForm() throws SourceErrors {
    javaAndExplorationAgreeOnEachStep(33098);
  }

  @Example
  void aNaturalNumberIsNotSoughtBelowZero() throws SourceErrors {
    javaAndExplorationAgreeOnEachStep(-2744082863750870841L);
  }

  @Property(tries = 5, shrinking = ShrinkingMode.OFF)
  @Tag("long")
  void javaAndExplorationAgreeOnEachStep(@ForAll long seed) throws SourceErrors {
    Random random = new Random(seed);
    agree(random, source(random, action -> true), STEPS, (state, steps) -> {});
  }

  /** A random run, on which both agree; {@code seen} takes each state of the Java, and its steps. */
  static void agree(Random random, String source, int length, BiConsumer<Object, Steps> seen)
      throws SourceErrors {
    Automaton automaton = new SourceReader().read("x.starl", source).getFirst();
    Machine machine = new Machine(automaton, new Sizes(Map.of("T", IDS.size()), NAT, 2));
    Compiled java = new Compiled(source);
    Row state = machine.starts(Map.of()).states().getFirst();
    assertThat(text(automaton, java.value())).isEqualTo(text(machine, state));
    int enabled = 0;
    int disabled = 0;
    for (int step = 0; step < length; step++) {
      Steps steps = new Steps();
      for (Call call : calls()) {
        compare(machine, state, java, call, steps);
      }
      seen.accept(java.value(), steps);
      enabled += steps.enabled.size();
      disabled += steps.disabled.size();
      if (steps.rows.isEmpty()) {
        break;
      }
      int chosen = random.nextInt(steps.rows.size());
      state = steps.rows.get(chosen);
      java.go(steps.java.get(chosen));
    }
    assertThat(enabled).as("enabled actions").isGreaterThan(10);
    assertThat(disabled).as("disabled actions").isGreaterThan(10);
  }

  /** Actions that are wanted, and whose conditions have a Java form. */
  static String source(Random random, Predicate<String> isWanted) throws SourceErrors {
    RandomSource generator = new RandomSource(random);
    StringBuilder text = new StringBuilder(RandomSource.HEAD);
    int refused = 0;
    for (int n = 0; n < ACTIONS; ) {
      String action = generator.action("act" + n);
      if (!isWanted.test(action)) {
        continue;
      }
      new SourceReader().read("x.starl", RandomSource.HEAD + action);
      if (isExecutable(RandomSource.HEAD + action)) {
        text.append(action);
        n++;
      } else {
        // About half of them: so many more would be an error of the generator or of the reader.
        assertThat(++refused).as("actions without a Java form").isLessThan(10 * ACTIONS);
      }
    }
    return text.toString();
  }

  private static boolean isExecutable(String text) {
    try {
      return !Compiled.files(text).isEmpty();
    } catch (SourceErrors e) {
      assertThat(e.getMessage())
          .containsAnyOf(
              "are not known to be finitely many", "expected values that do not depend on it");
      return false;
    }
  }

  private static void compare(Machine machine, Row state, Compiled java, Call call, Steps steps) {
    String name = "act" + call.action;
    String about =
        "%s%s, pre %s, in %s"
            .formatted(
                name,
                List.of(call.java),
                machine.automaton().action(name).orElseThrow().pre().stream()
                    .map(each -> each.text())
                    .toList(),
                text(machine, state));
    try {
      boolean isEnabled = machine.firstFalse(state, call.action, call.arguments).isEmpty();
      assertThat(java.enabled(name, call.java).isTrue())
          .as("enabled: %s", about)
          .isEqualTo(isEnabled);
      (isEnabled ? steps.enabled : steps.disabled).add(call);
      if (isEnabled) {
        Row after = machine.after(state, call.action, call.arguments);
        Object made = java.after(name, call.java);
        assertThat(text(machine.automaton(), made))
            .as("after: %s", about)
            .isEqualTo(text(machine, after));
        steps.rows.add(after);
        steps.java.add(made);
      }
    } catch (Beyond e) {
      steps.beyond.add(call);
    }
  }

  private static List<Call> calls() {
    List<Call> calls = new ArrayList<>();
    for (int action = 0; action < ACTIONS; action++) {
      for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 2; j++) {
          for (long c = 0; c < 3; c++) {
            calls.add(
                new Call(
                    action,
                    new Object[] {IDS.get(i), IDS.get(j), c},
                    List.of(new Id(i), new Id(j), Num.of(c))));
          }
        }
      }
    }
    return calls;
  }

  private static String text(Machine machine, Row state) {
    List<String> parts = new ArrayList<>();
    for (int i = 0; i < machine.parts().size(); i++) {
      parts.add(machine.parts().get(i).domain().text(state.get(i)));
    }
    return String.join("; ", parts);
  }

  /** The same of a state of the Java. */
  private static String text(Automaton automaton, Object state) {
    return automaton.state().stream()
        .map(component -> text(component.type(), field(state, component.name())))
        .collect(Collectors.joining("; "));
  }

  static Object field(Object of, String name) {
    try {
      Method accessor = of.getClass().getMethod(name);
      accessor.setAccessible(true);
      return accessor.invoke(of);
    } catch (ReflectiveOperationException e) {
      throw new AssertionError(e);
    }
  }

  @SuppressWarnings("unchecked") // all maps are of ids
  static String text(Type type, Object value) {
    return switch (type) {
      case Type.SetOf set -> texts(set.element(), (Collection<?>) value, "{", "}");
      case Type.ListOf list -> texts(list.element(), (Collection<?>) value, "[", "]");
      case Type.OptionOf option ->
          value instanceof Lift.up<?> up
              ? "some(" + text(option.element(), up.value()) + ")"
              : "none";
      case Type.MapOf map ->
          IDS.stream()
              .map(id -> id + " -> " + text(map.result(), ((Fun<String, ?>) value).at(id)))
              .collect(Collectors.joining(", ", "[", "]"));
      case Type.Rec rec ->
          rec.fields().stream()
              .map(each -> each.name() + " := " + text(each.type(), field(value, each.name())))
              .collect(Collectors.joining(", ", rec.name() + "(", ")"));
      case Type.Sum sum -> value instanceof Term term ? term.text() : value.toString();
      default -> value.toString();
    };
  }

  private static String texts(Type element, Collection<?> values, String begin, String end) {
    return values.stream()
        .map(each -> text(element, each))
        .collect(Collectors.joining(", ", begin, end));
  }
}
