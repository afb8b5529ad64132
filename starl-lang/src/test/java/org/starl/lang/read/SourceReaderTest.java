package org.starl.lang.read;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Type;

class SourceReaderTest {

  private static final String LAMP =
      """
      // A lamp.
      automaton Lamp[PIDS]
      type Color = red | green
      state
        by: option[PIDS] // holds the switch
        shows: Color
      start by = none, shows = red
      fun free?: bool = by = none
      // Takes the switch.
      action take(i: PIDS) // once
        pre free?
        eff by := some(i)
      action change(i: PIDS)
        pre by = some(i)
        eff shows := if shows = red then green else red
      """;

  @ParameterizedTest
  @CsvSource(
      delimiter = '~',
      textBlock =
          """
          pre free? ~ pre free? && true ~ 11:13: found '&'; expected 'and'
          pre free? ~ pre free? || true ~ 11:13: found '|'; expected 'or'
          pre free? ~ pre free? -> true ~ 11:13: found '->'; expected '=>' for an implication
          pre free? ~ pre !free? ~ 11:7: found '!'; expected 'not'
          pre free? ~ pre by == none ~ 11:10: found '='; expected one '='
          pre free? ~ pre by <> none ~ 11:11: found '>'; expected '!=' for not equal
          pre free? ~ require free? ~ 11:3: found 'require'; expected 'pre'
          pre free? ~ when free? ~ 11:3: found 'when'; expected 'pre' before the conditions of an action; 'when' is for locations
          eff by := some(i) ~ do by := some(i) ~ 12:3: found 'do'; expected 'eff' before the effects of an action; 'do' is for locations
          eff by := some(i) ~ eff by = some(i) ~ 12:10: found '='; expected ':=' after the place, as in 'c := c + 1'
          eff by := some(i) ~ eff by := some(i); shows := red ~ 12:20: found ';'; expected ',' between conditions and effects, and nothing after the last one
          eff by := some(i) ~ eff by := some(i) shows := red ~ 12:21: found 'shows'; expected ',' before a further condition or effect, or the next declaration or branch
          start by = none, ~ start by = none; ~ 7:16: found ';'; expected ',' between conditions and effects, and nothing after the last one
          start by ~ init by ~ 7:6: 'init' is a name here; expected 'start'
          action take ~ transition take ~ 10:1: found 'transition'; expected 'action'
          state ~ var ~ 4:1: found 'var'; expected 'state'
          fun free?: bool = by = none ~ fun free?: bool = by[1] = none ~ 8:21: found '['; expected '(': the value of a map m at i is m(i)
          fun free?: bool = by = none ~ fun free?: bool = 1 % 2 = 0 ~ 8:21: found '%'; expected 'mod'
          fun free?: bool = by = none ~ fun free?: bool = free? ~ 8:1: 'free?' calls itself; expected 'measure' and a natural number that becomes smaller with each call
          fun free?: bool = by = none ~ fun free?: bool = dark? or lit? fun dark?: bool = by = none fun lit?: bool = not free? ~ 8:1: 'free?' calls itself through 'lit?'; expected a function that calls itself directly
          fun free?: bool = by = none ~ assume 1 > 0 fun free?: bool = by = none ~ 8:8: found '1'; expected a name and ':' before what is said, as in 'assume Some: n > 0'
          fun free?: bool = by = none ~ invariant by = none fun free?: bool = by = none ~ 8:14: found '='; expected a name and ':' before what is said, as in 'invariant Some: n > 0'
          fun free?: bool = by = none ~ progress eventually by = none fun free?: bool = by = none ~ 8:10: found 'eventually'; expected a name and ':' before what is said, as in 'progress Some: n > 0 leads to n = 0'
          action take(i: PIDS) ~ action take(i) ~ 10:14: found ')'; expected ':' and a type after a name, as in '(i: PIDS)'
          action take(i: PIDS) ~ action take() ~ 10:13: found ')'; expected no parentheses where nothing is in them
          shows: Color ~ shows Color ~ 6:9: found 'Color'; expected ':' and a type after each component, as in 'state a: nat b: nat'
          shows: Color ~ shows, was: Color ~ 6:8: found ','; expected ':' and a type after each component, as in 'state a: nat b: nat'
          by: option[PIDS] ~ by: option[PIDS], ~ 5:19: found ','; expected no ',' between components, as in 'state a: nat b: nat'
          type Color = red | green ~ type Color = red, green ~ 3:17: found ','; expected forms with '|' between them, as in 'type Color = red | green'
          type Color = red | green ~ type Color = {red, green} ~ 3:14: found '{'; expected forms with '|' between them, as in 'type Color = red | green'
          by: option[PIDS] ~ by: option[record(i: PIDS)] ~ 5:20: found '('; expected a name: declare 'type Name = record(...)', and use it here
          eff by := some(i) ~ eff if free? then by := some(i) ~ 12:24: found ':='; expected the condition behind ':=', as in 'c := if a then 1 else c'
          eff by := some(i) ~ eff let x = some(i) :: by := x ~ 12:11: found 'x'; expected 'let' behind ':=', as in 'c := let x = c + 1 :: x * x'
          eff by := some(i) ~ eff for j in PIDS by := some(j) ~ 12:11: found 'j'; expected all values of a map at once, as in 'm := [i: PIDS -> 0]'
          // A lamp. ~ # A lamp. ~ 1:1: found '#'; expected '//' before a comment
          type Color = red ~ type Färbung = red ~ 3:7: found 'ä'; expected names of the letters a to z, digits and '_'
          by: option[PIDS] ~ _by: option[PIDS] ~ 5:3: found '_'; expected a name that begins with a letter
          type Color = red ~ type Both = record(in: bool) type Color = red ~ 3:20: found 'in'; expected a name, which no word of the language is
          type Color = red | green ~ type Color = red | green(by: Robot) type Both = record(of: Color) fun dark(c: Color): bool = c = green ~ 3:30: 'Robot' is no type; expected one of bool, nat, int, time, real, PIDS
          type Color = red | green ~ type Color = Color ~ 3:14: 'Color' is no type; expected one of bool, nat, int, time, real, PIDS
          automaton Lamp[PIDS] ~ automaton Lamp[PIDS, first: first] assume A: first = none ~ 2:29: 'first' is no type; expected one of bool, nat, int, time, real, PIDS, Color
          type Color = red ~ -- a type ~ 3:1: found '-'; expected '//' before a comment, or a value before '-'
          type Color = red ~ type Half = 0..4 / 2 type Color = red ~ 3:18: found '/'; expected '//' before a comment, or a value before '/'; bounds of types have no '/'
          pre free? ~ pre i not in {i} ~ 11:9: found 'not'; expected 'not' before the whole condition, as in 'not i in s', or in parentheses
          pre free? ~ pre free? ∧ true ~ 11:13: found '∧'; expected 'and'
          pre free? ~ pre ∃ j: PIDS :: free? ~ 11:7: found '∃'; expected 'exists'
          pre free? ~ pre size({1}) = 1 ~ 11:7: 'size' is not known here; expected card, or another of 14 names
          pre free? ~ pre 0 <= 1 <= 2 ~ 11:7: '0 <= 1' is of type bool; expected real; two comparisons are joined by 'and'
          pre free? ~ pre {1} + {2} = {3} ~ 11:7: '{1}' is of type set[nat]; expected real; sets have union, minus and intersect
          pre free? ~ pre {i} union i = {i} ~ 11:17: 'i' is of type PIDS, and '{i}' of type set[PIDS]; expected two of one type: {i}
          pre free? ~ pre 1234567890123456789 = 1 ~ 11:7: 1234567890123456789 is too long; expected at most 18 digits
          fun free?: bool = by = none ~ fun free?: bool = match shows { red -> true, red -> true, green -> true } ~ 8:46: 'red' is here twice; expected it once
          fun free?: bool = by = none ~ fun f(m: map[PIDS, bool], i: PIDS): map[PIDS, bool] = m minus {i} fun free?: bool = true ~ 8:63: '{i}' is of type set[PIDS], and 'm' of type [PIDS -> option[bool]]; expected two of one type; the keys of a map m change by m(k) := some(v) and m(k) := none
          """)
  void commonMistakeIsToldWithItsCureAlone(String instead, String mistake, String told) {
    SourceErrors errors =
        catchThrowableOfType(
            SourceErrors.class,
            () ->
                new SourceReader()
                    .read(
                        "lamp.starl",
                        LAMP.replaceFirst(java.util.regex.Pattern.quote(instead), mistake)));
    assertThat(errors.errors()).hasToString("[lamp.starl:" + told + "]");
  }

  @Test
  void sourceBecomesATree() throws SourceErrors {
    Automaton lamp = new SourceReader().read("lamp.starl", LAMP).getFirst();
    assertThat(lamp.comment()).containsExactly("A lamp.");
    assertThat(lamp.state())
        .extracting(c -> c.type().toString())
        .containsExactly("option[PIDS]", "Color");
    assertThat(lamp.state().getFirst().note()).isEqualTo("holds the switch");
    assertThat(lamp.action("take").orElseThrow().comment()).containsExactly("Takes the switch.");
    assertThat(lamp.action("take").orElseThrow().note()).isEqualTo("once");
    assertThat(lamp.action("take").orElseThrow().pre().getFirst().text()).isEqualTo("free?");
    assertThat(lamp.function("free?").orElseThrow().signature().readsState()).isTrue();
    assertThat(((Type.Sum) lamp.types().getFirst().type()).isEnum()).isTrue();
  }

  @Test
  void matchHasTheTypeOfItsCases() throws SourceErrors {
    String text =
        LAMP.replace("state\n", "state\n  n: nat\n")
            .replace(
                "by := some(i)", "by := some(i), n := (match shows { red -> 0, green -> n }) + n");
    assertThat(new SourceReader().read("lamp.starl", text)).hasSize(1);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          shows = red then green | shos = red then green | 15:19: 'shos' is not known here; expected shows, or another of 14 names
          by := some(i) | by := i | 12:13: 'i' is of type PIDS; expected option[PIDS]: some(i)
          by := some(i) | bi := some(i) | 12:7: 'bi' is no component of the state; expected one of [by, shows]
          shows: Color | shows: Colour | 6:10: 'Colour' is no type; expected one of bool, nat, int, time, real, PIDS, Color; is it Color?
          pre free? | pre free?(i) | 11:7: 'free?' has 1 arguments here; expected 0
          pre free? | pre 3 | 11:7: '3' is of type nat; expected bool
          pre by = some(i) | pre [i] + [i] = [i] | 14:7: '[i]' is a list; expected '++' between two lists
          pre by = some(i) | pre [i] ++ i = [i] | 14:14: 'i' is of type PIDS; expected a list of it, [i]
          pre by = some(i) | pre by ++ [i] = [i] | 14:7: 'by' is of type option[PIDS]; expected a list
          pre by = some(i) | pre card(by) = 1 | 14:12: 'by' is of type option[PIDS]; expected a set
          pre by = some(i) | pre let red = 1 :: red = 1 | 14:11: 'red' is a value of Color already; expected a new name
          pre by = some(i) | pre let x = 1 in {1} | 15:3: found 'eff'; expected '::'
          pre by = some(i) | pre [i](0, 1) = i | 14:7: '[i]' has 2 arguments here; expected 1: int
          action change(i: PIDS) | action change(i, the: PIDS) | 13:18: 'the' is a function of the language already; expected a new name
          action change(i | action take(i | 13:8: action 'take' is here twice; expected different names
          then green else red | then green | 16:1: found the end of the file; expected 'else'
          by = none, shows | {} = {}, shows | 7:12: nothing here says of what type the elements of '{}' are; expected a set or list of a known type beside it
          """)
  void wrongSourceIsToldWithItsPlace(String right, String wrong, String error) {
    SourceErrors told = errors(LAMP.replace(right, wrong));
    assertThat(told.getMessage()).isEqualTo("lamp.starl:" + error);
  }

  @Test
  void errorsAreToldTogether() {
    SourceErrors told =
        errors(LAMP.replace("by = none, shows", "b = none, show").replace("some(i)", "i"));
    assertThat(told.errors()).extracting(e -> e.pos().line()).containsExactly(7, 7, 12, 14);
  }

  @Test
  void assumptionIsOfParametersAlone() {
    SourceErrors told = errors(LAMP.replace("type Color", "assume Free: by = none\ntype Color"));
    assertThat(told.getMessage()).startsWith("lamp.starl:3:14: 'by' is not known here;");
  }

  @Test
  void automatonWithoutStartIsRefused() {
    String text =
        LAMP.lines().filter(line -> !line.startsWith("start")).reduce("", (a, b) -> a + b + "\n");
    assertThat(errors(text).errors())
        .extracting(SourceError::message)
        .containsExactly(
            "automaton 'Lamp' has no start; expected 'start' and a condition on its first states");
  }

  @Test
  void fileMayBeginWithAByteOrderMark(@TempDir Path folder) throws IOException, SourceErrors {
    Path file = Files.writeString(folder.resolve("A.starl"), "\uFEFF" + LAMP);
    assertThat(new SourceReader().read(file)).hasSize(1);
  }

  @Test
  void expressionThatNestsTooDeeplyIsTold() {
    String deep = "not (".repeat(50_000) + "free?" + ")".repeat(50_000);
    String told = ": an expression nests too deeply; expected shorter expressions";
    assertThat(errors(LAMP.replace("pre free?", "pre " + deep)).getMessage())
        .isEqualTo("lamp.starl:11:3" + told);
    String wide = "free?" + " and free?".repeat(50_000);
    assertThat(errors(LAMP.replace("pre free?", "pre " + wide)).getMessage())
        .isEqualTo("lamp.starl:10:1" + told);
    assertThat(errors(LAMP.replace("by = none\n", "by = none and " + wide + "\n")).getMessage())
        .isEqualTo("lamp.starl:8:1" + told);
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void expressionThatDoublesFortyTimesIsTold(boolean isOfFunctions) {
    StringBuilder doubled = new StringBuilder(isOfFunctions ? "" : "fun all(x0: nat): nat = ");
    for (int i = 1; i <= 40; i++) {
      doubled.append(
          isOfFunctions
              ? "fun x%d(k: nat): nat = %s\n"
                  .formatted(i, i == 1 ? "k" : "x%d(k) + x%d(k)".formatted(i - 1, i - 1))
              : "let x%d = x%d + x%d :: ".formatted(i, i - 1, i - 1));
    }
    doubled.append(isOfFunctions ? "" : "x40");
    assertThat(errors(LAMP + doubled).errors())
        .singleElement()
        .extracting(SourceError::message)
        .asString()
        .matches("'x\\d+' stands for more than 100,000 operations, .*; expected fewer uses");
  }

  @Test
  void unitsHaveDifferentNames() {
    assertThat(errors(LAMP + "\n" + LAMP).errors())
        .hasToString("[lamp.starl:18:11: 'Lamp' is here twice; expected different names]");
  }

  @Test
  void expressionOutsideOfASourceIsReadWithTheTypesOfAnAutomaton() throws SourceErrors {
    Automaton lamp = new SourceReader().read("lamp.starl", LAMP).getFirst();
    Type color = lamp.types().getFirst().type();
    List<Type.Field> names = List.of(new Type.Field("bot0", new Type.Opaque("PIDS")));
    Expr red = SourceReader.readExpression(lamp, names, color, "--value", "red");
    assertThat(red.type()).isEqualTo(color);
    for (String wrong : List.of("blue", "bot0", "red green", "(red", "")) {
      assertThatThrownBy(() -> SourceReader.readExpression(lamp, names, color, "--value", wrong))
          .as(wrong)
          .isInstanceOf(SourceErrors.class)
          .hasMessageStartingWith("--value:1:");
    }
  }

  private static SourceErrors errors(String text) {
    SourceErrors told =
        catchThrowableOfType(SourceErrors.class, () -> new SourceReader().read("lamp.starl", text));
    assertThat(told).as("the source is accepted").isNotNull();
    assertThat(told.errors()).isEqualTo(List.copyOf(told.errors()));
    return told;
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '~',
      textBlock =
          """
          action change(i ~ action take(i ~ 13:8: action 'take' is here twice; expected different names
          // Takes ~ invariant A: true invariant A: true // Takes ~ 9:29: invariant 'A' is here twice; expected different names
          // Takes ~ assume A: true assume A: true // Takes ~ 9:23: assumption 'A' is here twice; expected different names
          // Takes ~ progress A: eventually true progress A: no deadlock // Takes ~ 9:38: progress 'A' is here twice; expected different names
          eff by := some(i) ~ eff m := [j: PIDS -> c], m(i) := c ~ 14:28: 'm(i)' is changed twice; expected one effect on each place
          eff by := some(i) ~ eff m(i).a := 0, m(i) := c ~ 14:20: 'm(i)' is changed twice; expected one effect on each place
          eff by := some(i) ~ eff c := C(a := 0), c.a := 0 ~ 14:23: 'c.a' is changed twice; expected one effect on each place
          type Color = red ~ type Early = option[Color] type Color = red ~ 3:21: 'Color' is declared below; expected it above
          """)
  void namesThatAreThereTwiceOrTooLateAreTold(String part, String wrong, String message) {
    String lamp =
        part.startsWith("eff")
            ? LAMP.replace("state\n", "type C = record(a: nat)\nstate m: [PIDS -> C]\n  c: C\n")
            : LAMP;
    assertThat(errors(lamp.replace(part, wrong)).errors())
        .hasToString("[lamp.starl:" + message + "]");
  }

  @Test
  void carriageReturnsEndLines() {
    String wrong = LAMP.replace("shows = red\n", "shows = blue\n");
    assertThat(errors(wrong.replace("\n", "\r")).errors()).isEqualTo(errors(wrong).errors());
    assertThat(errors(wrong.replace("\n", "\r\n")).errors()).isEqualTo(errors(wrong).errors());
  }
}
