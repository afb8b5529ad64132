package org.starl.sim.fault;

import java.util.List;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.starl.geometry.Circle;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Region;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.sim.net.Latency;
import org.starl.sim.net.Verdict;
import org.starl.sim.world.Unsynced;

/**
 * A type of arguments of faults.
 *
 * @param reader throws {@link BadInput} if a text is not a value
 * @param writer writes a value in its canonical form, which the reader reads back
 */
record ArgumentType<T>(Function<String, T> reader, Function<T, String> writer) {

  private static final String LOST = "lost";

  static final ArgumentType<RobotSelector> ROBOTS =
      new ArgumentType<>(RobotSelector::parse, RobotSelector::toString);
  static final ArgumentType<Double> PROBABILITY =
      new ArgumentType<>(Quantities::probability, Quantities::numberText);
  static final ArgumentType<Long> DURATION =
      new ArgumentType<>(Quantities::durationNs, Quantities::durationText);
  static final ArgumentType<Long> POSITIVE_DURATION =
      new ArgumentType<>(ArgumentType::positiveNs, Quantities::durationText);
  // Attacks at shorter intervals would take all of the simulator's time.
  static final ArgumentType<Long> INTERVAL =
      new ArgumentType<>(ArgumentType::intervalNs, Quantities::durationText);
  static final ArgumentType<Long> SIGNED_DURATION =
      new ArgumentType<>(
          text ->
              isNegative(text) ? -Quantities.durationNs(tail(text)) : Quantities.durationNs(text),
          ns -> (ns < 0 ? "-" : "") + Quantities.durationText(Math.abs(ns)));
  static final ArgumentType<TimeRange> TIME_RANGE =
      new ArgumentType<>(TimeRange::parse, TimeRange::toString);
  static final ArgumentType<Long> PPM = new ArgumentType<>(ArgumentType::ppm, ppm -> ppm + "ppm");
  static final ArgumentType<Double> DISTANCE =
      new ArgumentType<>(Quantities::distanceMm, Quantities::distanceText);
  static final ArgumentType<Double> ANGLE =
      new ArgumentType<>(Quantities::angleRad, Quantities::angleText);
  static final ArgumentType<Double> POSITIVE_SPEED =
      new ArgumentType<>(ArgumentType::positiveSpeed, Quantities::speedText);
  static final ArgumentType<Latency> LATENCY =
      new ArgumentType<>(Latency::parse, Latency::toString);
  static final ArgumentType<Long> COUNT =
      new ArgumentType<>(
          text -> Quantities.whole(text, 0, Long.MAX_VALUE), number -> Long.toString(number));
  static final ArgumentType<Verdict> FATE =
      new ArgumentType<>(
          text ->
              text.equals(LOST)
                  ? Verdict.drop("loss")
                  : Verdict.exactly(Quantities.durationNs(text)),
          fate ->
              fate instanceof Verdict.Exactly exactly
                  ? Quantities.durationText(exactly.delayNs())
                  : LOST);
  static final ArgumentType<Unsynced> UNSYNCED =
      new ArgumentType<>(
          ArgumentType::unsynced, value -> value == Unsynced.KEPT ? "nothing" : "some");
  // Two corners, or centre and radius. Coordinates are signed distances.
  static final ArgumentType<Region> AREA =
      new ArgumentType<>(ArgumentType::area, ArgumentType::text);

  private static final long LEAST_INTERVAL_NS = 100_000;
  private static final long MOST_PPM = 500_000;
  private static final Pattern AREA_FORM = Pattern.compile("\\s*(rect|circle)\\((.*)\\)\\s*");

  private static long positiveNs(String text) {
    long ns = Quantities.durationNs(text);
    if (ns == 0) {
      throw bad(text, "expected a duration above 0");
    }
    return ns;
  }

  private static long intervalNs(String text) {
    long ns = Quantities.durationNs(text);
    if (ns < LEAST_INTERVAL_NS) {
      throw bad(text, "expected at least " + Quantities.durationText(LEAST_INTERVAL_NS));
    }
    return ns;
  }

  private static double positiveSpeed(String text) {
    double mmPerS = Quantities.speedMmPerS(text);
    if (mmPerS == 0) {
      throw bad(text, "expected a speed above 0");
    }
    return mmPerS;
  }

  private static long ppm(String text) {
    String number = text.endsWith("ppm") ? text.substring(0, text.length() - 3) : "";
    try {
      return Quantities.whole(number, -MOST_PPM, MOST_PPM);
    } catch (BadInput wrong) {
      throw bad(text, "expected -500000ppm to 500000ppm, such as 200ppm");
    }
  }

  private static Unsynced unsynced(String text) {
    return switch (text) {
      case "unsynced" -> Unsynced.LOST;
      case "some" -> Unsynced.SOME;
      case "nothing" -> Unsynced.KEPT;
      default -> throw bad(text, "expected unsynced, some or nothing");
    };
  }

  private static Region area(String text) {
    Matcher form = AREA_FORM.matcher(text);
    if (form.matches()) {
      List<String> parts = List.of(form.group(2).split(",", -1));
      try {
        if (form.group(1).equals("rect") && parts.size() == 4) {
          return new Rectangle(mm(parts, 0), mm(parts, 1), mm(parts, 2), mm(parts, 3));
        }
        if (form.group(1).equals("circle") && parts.size() == 3) {
          return new Circle(
              new Point(mm(parts, 0), mm(parts, 1)), Quantities.distanceMm(parts.get(2)));
        }
      } catch (IllegalArgumentException wrongSides) {
        throw bad(text, String.valueOf(wrongSides.getMessage()));
      }
    }
    throw bad(text, "expected rect(0,0,2m,1m), two corners, or circle(0,0,2m)");
  }

  private static String text(Region area) {
    return switch (area) {
      case Rectangle r ->
          "rect("
              + String.join(
                  ",", text(r.xMinMm()), text(r.yMinMm()), text(r.xMaxMm()), text(r.yMaxMm()))
              + ")";
      case Circle c ->
          "circle("
              + String.join(",", text(c.center().xMm()), text(c.center().yMm()), text(c.radiusMm()))
              + ")";
      default -> throw new IllegalArgumentException(area + ": expected a rectangle or a circle");
    };
  }

  private static double mm(List<String> parts, int index) {
    String part = parts.get(index).strip();
    return isNegative(part) ? 0.0 - Quantities.distanceMm(tail(part)) : Quantities.distanceMm(part);
  }

  private static String text(double mm) {
    return (mm < 0 ? "-" : "") + Quantities.distanceText(Math.abs(mm));
  }

  private static boolean isNegative(String text) {
    return text.startsWith("-");
  }

  private static String tail(String text) {
    return text.substring(1);
  }

  private static BadInput bad(String text, String expected) {
    return new BadInput(BadInput.quote(text) + ": " + expected);
  }
}
