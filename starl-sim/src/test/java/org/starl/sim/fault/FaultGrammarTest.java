package org.starl.sim.fault;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.sim.net.Latency;

class FaultGrammarTest {

  @ParameterizedTest
  @ValueSource(
      strings = {
        "crash(bot2,at=12s)",
        "crash(bot2,at=12s,restart=5s)",
        "crash(any,lose=some,at=5s..20s,restart=1s..3s)",
        "loss(0.3)",
        "loss(0.9,from=bot1,to=bot2+bot3,for=5s)",
        "burst(2s,200ms,0.9)",
        "delay(uniform(10ms,200ms),until=1min)",
        "duplicate(0.1)",
        "reorder(0.2,100ms)",
        "partition(bot0+bot1|bot2+bot3)",
        "partition(bot0>bot1,at=5s,for=2s..9s)",
        "partition(any)",
        "partition(area=rect(-1mm,0mm,2000mm,1000mm))",
        "partition(area=circle(0mm,-5.5mm,2000mm),at=1s)",
        "range(3000mm)",
        "sight",
        "sight(at=3s)",
        "stuck(all)",
        "slow(bot1,0.5)",
        "noise(bot1,30mm)",
        "dropout(bot1,at=1ns,until=2s)",
        "jump(bot1,300mm)",
        "compute(bot1,20ms)",
        "drift(bot1,-200ppm)",
        "skew(bot1,-50ms)",
        "disk(bot1,50ms)",
        "ram(bot1)",
        "ram(bot1,100mm/s)",
        "block(bot1,at=3s,for=10s)"
      })
  void theShortestFormIsWrittenUnchanged(String text) {
    String canonical = text.replace("1min", "60s");
    assertThat(FaultGrammar.parse(text)).hasToString(canonical);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        " crash ( bot2 , at = 12s ) ; crash(bot2,at=12s)",
        "crash(bot2,from=12s,lose=unsynced); crash(bot2,at=12s)",
        "crash(bot2,restart=5s,at=12s,lose=nothing); crash(bot2,lose=nothing,at=12s,restart=5s)",
        "range(3m); range(3000mm)",
        "sight(); sight",
        "duplicate(0.1,50ms); duplicate(0.1)",
        "loss(0.5,from=1s,for=2s,from=bot1); loss(0.5,from=bot1,at=1s,for=2s)",
        "noise(bot1,3cm,180deg); noise(bot1,30mm,3.141592653589793rad)",
        "burst(2s,200ms,1); burst(2s,200ms)"
      })
  void equivalentSpellingsAreAccepted(String text, String canonical) {
    assertThat(FaultGrammar.parse(text)).hasToString(canonical);
  }

  @Property
  void aWrittenFaultIsReadBack(@ForAll("faults") Fault fault) {
    assertThat(FaultGrammar.parse(fault.toString())).isEqualTo(fault);
  }

  @Property(tries = 200)
  void aWrittenPlanIsReadBack(@ForAll("plans") FaultPlan plan) {
    assertThat(FaultPlan.parse(plan.toString())).isEqualTo(plan);
  }

  @Property
  void anyTextIsAFaultOrRefusedInOneLine(@ForAll("typed") String text) {
    try {
      FaultGrammar.parse(text);
    } catch (BadInput e) {
      assertThat(e.getMessage()).doesNotContain("\n").isNotEmpty();
    }
  }

  @Provide
  Arbitrary<String> typed() {
    Arbitrary<String> pieces =
        Arbitraries.of(
            "crash",
            "loss",
            "partition",
            "delay",
            "uniform",
            "area",
            "rect",
            "circle",
            "(",
            ")",
            ",",
            "=",
            "|",
            ">",
            "+",
            "at",
            "for",
            "until",
            "from",
            "5s",
            "..",
            "0.3",
            "bot1",
            "any",
            "all",
            "-",
            "ppm",
            "mm",
            " ",
            "\n",
            "x");
    return pieces.list().ofMaxSize(14).map(list -> String.join("", list));
  }

  @Provide
  Arbitrary<FaultPlan> plans() {
    return faults().list().ofMaxSize(5).map(FaultPlan::new);
  }

  @Provide
  Arbitrary<Fault> faults() {
    return Combinators.combine(effects(), spans())
        .as((effect, span) -> new Fault(FaultGrammar.parse(effect).effect(), span));
  }

  private static Arbitrary<Span> spans() {
    Arbitrary<TimeRange> lasting = ranges().injectNull(0.3);
    return Combinators.combine(ranges(), lasting, times(), Arbitraries.of(true, false))
        .as((at, forTime, extra, ends) -> {
          boolean hasUntil = forTime == null && ends;
          return new Span(at, forTime, hasUntil ? at.mostNs() + extra : Span.NEVER);
        });
  }

  private static Arbitrary<TimeRange> ranges() {
    return Combinators.combine(times(), times(), Arbitraries.of(true, false))
        .as((a, b, isOne) -> isOne ? TimeRange.exactly(a) : new TimeRange(a, a + b));
  }

  private static Arbitrary<Long> times() {
    return Arbitraries.longs().between(0, 1_000_000_000_000_000L);
  }

  private static Arbitrary<String> robots() {
    return Arbitraries.of("all", "any", "half", "bot0", "a-b.c_D9+bot10");
  }

  /** Texts of effects, each with the arguments of its kind. */
  private static Arbitrary<String> effects() {
    Arbitrary<String> p =
        Arbitraries.doubles().between(0, 1).ofScale(6).map(Quantities::numberText);
    Arbitrary<String> mm =
        Arbitraries.doubles().between(0, 100_000).ofScale(3).map(Quantities::distanceText);
    Arbitrary<String> at = Combinators.combine(Arbitraries.of("", "-"), mm).as(String::concat);
    Arbitrary<String> t = times().map(Quantities::durationText);
    Arbitrary<String> positive = times().map(ns -> Quantities.durationText(ns + 1));
    Arbitrary<String> interval = times().map(ns -> Quantities.durationText(ns + 100_000));
    Arbitrary<String> signed = Combinators.combine(Arbitraries.of("", "-"), t).as(String::concat);
    Arbitrary<String> rad =
        Arbitraries.doubles().between(0, 3.14).ofScale(4).map(Quantities::angleText);
    Arbitrary<String> ppm = Arbitraries.longs().between(-500_000, 500_000).map(x -> x + "ppm");
    Arbitrary<String> speed =
        Arbitraries.doubles().between(1, 1000).ofScale(3).map(Quantities::speedText);
    Arbitrary<String> from = robots().map(robots -> "from=" + robots);
    Arbitrary<String> to = robots().map(robots -> "to=" + robots);
    Arbitrary<String> lose = Arbitraries.of("unsynced", "some", "nothing").map("lose="::concat);
    return Arbitraries.oneOf(
        text("crash", List.of(robots(), lose)),
        text("loss", List.of(p, from, to)),
        text("burst", List.of(positive, positive, p, from, to)),
        text("delay", List.of(latencies(), from, to)),
        text("duplicate", List.of(p, t, from, to)),
        text("reorder", List.of(p, t, from, to)),
        text(
            "datagram",
            List.of(
                Arbitraries.just("bot0>bot1"),
                Arbitraries.longs().greaterOrEqual(0).map(String::valueOf),
                Arbitraries.oneOf(t, Arbitraries.just("lost")))),
        robots()
            .list()
            .ofMinSize(1)
            .ofMaxSize(3)
            .map(groups -> "partition(" + String.join("|", groups) + ")"),
        Combinators.combine(robots(), robots()).as((a, b) -> "partition(" + a + ">" + b + ")"),
        Combinators.combine(at, at, mm)
            .as((x, y, r) -> "partition(area=circle(" + String.join(",", x, y, r) + "))"),
        Combinators.combine(mm, mm)
            .as((x, y) -> "partition(area=rect(-" + x + ",-" + y + "," + x + "," + y + "))"),
        text("range", List.of(mm)),
        Arbitraries.just("sight"),
        robots().map(robots -> "stuck(" + robots + ")"),
        text("slow", List.of(robots(), p)),
        text("noise", List.of(robots(), mm, rad)),
        text("dropout", List.of(robots())),
        text("jump", List.of(robots(), mm)),
        text("compute", List.of(robots(), t)),
        text("drift", List.of(robots(), ppm)),
        text("skew", List.of(robots(), signed)),
        text("disk", List.of(robots(), t)),
        text("ram", List.of(robots(), speed)),
        text("block", List.of(robots())),
        text("forge", List.of(robots(), interval)),
        text("replay", List.of(robots(), interval)),
        text("flood", List.of(robots(), interval)));
  }

  private static Arbitrary<String> text(String name, List<Arbitrary<String>> arguments) {
    return Combinators.combine(arguments).as(values -> name + "(" + String.join(",", values) + ")");
  }

  private static Arbitrary<String> latencies() {
    return Combinators.combine(times(), times(), Arbitraries.integers().between(0, 3))
        .as((a, b, which) ->
            switch (which) {
              case 0 -> new Latency.Constant(a);
              case 1 -> new Latency.Uniform(a, a + b);
              case 2 -> new Latency.Normal(a, b);
              default -> new Latency.Exponential(a);
            })
        .map(Latency::toString);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "crash(bot2,att=12s) | 'crash(bot2,att=12s)': no argument is called 'att'; did you mean at?",
        "crush(bot2) | 'crush(bot2)': no fault is called 'crush'; did you mean crash?",
        "crash | 'crash': expected a robot's name, names (bot0+bot1), any, half or all, as in"
            + " crash(WHO,restart=5s,lose=unsynced)",
        "crash(2bot) | 'crash(2bot)': a robot's name, names (bot0+bot1), any, half or all: '2bot':"
            + " expected a robot's name, names (bot0+bot1), any, half or all",
        "crash(bot2,for=5s) | 'crash(bot2,for=5s)': no argument is called 'for'; expected one of"
            + " lose, at, restart, until",
        "crash(bot2,at=12) | 'crash(bot2,at=12)': at: '12': expected a duration with a unit (ns us"
            + " ms s min h), such as 100ms",
        "loss(1.5) | 'loss(1.5)': a probability: '1.5': expected a probability from 0 to 1, such as"
            + " 0.05",
        "loss(0.1,0.2) | 'loss(0.1,0.2)': '0.2' is an extra argument; expected"
            + " loss(0.3,from=WHO,to=WHO)",
        "loss(0.1,at=5s..2s) | 'loss(0.1,at=5s..2s)': at: '5s..2s': expected the earlier time first",
        "loss(0.1,for=5s,until=9s) | 'loss(0.1,for=5s,until=9s)': expected an end by 'for' or by"
            + " 'until', not by both",
        "loss(0.1,at=5s,until=4s) | 'loss(0.1,at=5s,until=4s)': expected 'until' not to be before"
            + " 'at'",
        "loss(0.1 | 'loss(0.1': expected a fault, such as crash(bot2,at=12s,restart=5s)",
        "loss((0.1) | 'loss((0.1)': expected a ) for each (",
        "loss(0.1,at=1s,at=2s) | 'loss(0.1,at=1s,at=2s)': expected 'at' only once",
        "drift(bot1,200) | 'drift(bot1,200)': a drift: '200': expected -500000ppm to 500000ppm,"
            + " such as 200ppm",
        "partition(area=box) | 'partition(area=box)': area: 'box': expected rect(0,0,2m,1m), two"
            + " corners, or circle(0,0,2m)"
      })
  void anErrorIsOneLine(String text, String expected) {
    assertThatThrownBy(() -> FaultGrammar.parse(text))
        .isInstanceOf(BadInput.class)
        .hasMessage(expected);
  }

  static List<FaultGrammar.Kind> kinds() {
    return FaultGrammar.kinds();
  }

  @ParameterizedTest
  @MethodSource("kinds")
  void theUsageExampleOfEachKindIsAFault(FaultGrammar.Kind kind) {
    Fault fault = FaultGrammar.parse(kind.usage().replace("WHO", "any"));
    assertThat(fault.effect().name()).isEqualTo(kind.name());
  }

  @Test
  void aPlanIsAListOfFaultsSeparatedBySemicolons() {
    FaultPlan plan = FaultPlan.parse(" loss(0.3) ; crash(bot0,at=1s);");
    assertThat(plan.faults()).hasSize(2);
    assertThat(plan).hasToString("loss(0.3); crash(bot0,at=1s)");
    assertThat(FaultPlan.parse("loss(0.3),crash(bot0,at=1s)")).isEqualTo(plan);
    assertThat(FaultPlan.parse("")).isEqualTo(FaultPlan.NONE);
  }
}
