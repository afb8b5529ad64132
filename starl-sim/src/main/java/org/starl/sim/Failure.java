package org.starl.sim;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Pose;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.motion.Deviation;
import org.starl.time.Time;

/**
 * What went wrong in a run: its first violation or, without one, why it has not finished, or the
 * error that ended it. Pictures, pages, reports and messages about a bad run show this description.
 *
 * @param kind what went wrong
 * @param lemma the violated one, with its primitive or app: {@code mutex.Exclusive}; else empty
 * @param sentence what the lemma says; empty if unknown
 * @param headline what went wrong, in one line
 * @param atNs when, in ns from the start of the run
 * @param culprits the robots involved, in order
 * @param region the part of the floor that it concerns; often {@link Nowhere}
 * @param faults the injected faults that had begun, those of the culprits first
 * @param cause the likely cause, in one line; empty if none is known
 * @param commands the command lines that repeat the run and shrink it, each with a word before it
 */
public record Failure(
    Kind kind,
    String lemma,
    String sentence,
    String headline,
    long atNs,
    List<Culprit> culprits,
    Region region,
    List<InjectedFault> faults,
    String cause,
    List<String> commands) {

  private static final int MOST_SHOWN = 6;

  /** What went wrong. */
  public enum Kind {
    /** A specification was violated. */
    VIOLATED,
    /** Some app did not end. */
    UNFINISHED,
    /** An error ended the run. */
    FAILED
  }

  /**
   * A robot involved in a failure, at that time.
   *
   * @param truth where its body was; null if it was not on the floor
   * @param deviation of what it believed; {@link Deviation#NONE} if it believed the truth, nearly
   */
  public record Culprit(RobotId robot, @Nullable Pose truth, Deviation deviation) {

    /** {@code bot1 was at 2724,2231 mm 94 deg, believed to be at 2724,2831 mm: 600 mm off}. */
    @Override
    public String toString() {
      Pose at = truth;
      if (at == null) {
        return robot + " was not on the floor";
      }
      String was = robot + " was at " + text(at);
      boolean isRight = deviation.distanceMm() < 1;
      return isRight
          ? was
          : was + ", believed to be at " + text(deviation.believed(at)) + ": " + deviation;
    }

    private static String text(Pose pose) {
      return String.format(
          Locale.ROOT,
          "%d,%d mm %d deg",
          StrictMath.round(pose.xMm()),
          StrictMath.round(pose.yMm()),
          StrictMath.round(StrictMath.toDegrees(pose.headingRad())));
    }
  }

  public Failure {
    culprits = List.copyOf(culprits);
    faults = List.copyOf(faults);
    commands = List.copyOf(commands);
  }

  /** Of a run that an error ended. */
  public static Failure ofError(String headline, long atNs) {
    return new Failure(
        Kind.FAILED, "", "", headline, atNs, List.of(), new Nowhere(), List.of(), "", List.of());
  }

  /** The robots involved, in order. */
  public List<RobotId> robots() {
    return culprits.stream().map(Culprit::robot).toList();
  }

  /** What is known beside the {@link #headline}, a line for each: without the commands. */
  public List<String> facts() {
    List<String> lines = new ArrayList<>();
    if (!sentence.isEmpty()) {
      lines.add(lemma + ": " + sentence);
    }
    addSome(lines, "fault: ", faults);
    lines.addAll(reasons());
    return lines;
  }

  /** Where its robots were, and the likely cause, a line for each. */
  public List<String> reasons() {
    List<String> lines = new ArrayList<>();
    addSome(lines, "", culprits);
    if (!cause.isEmpty()) {
      lines.add("likely cause: " + cause);
    }
    return lines;
  }

  /** Headline, facts and commands. */
  public List<String> lines() {
    List<String> lines = new ArrayList<>(List.of(headline));
    lines.addAll(facts());
    lines.addAll(commands);
    return lines;
  }

  private static void addSome(List<String> lines, String before, List<?> all) {
    int shown = Math.min(all.size(), MOST_SHOWN);
    all.subList(0, shown).forEach(each -> lines.add(before + each));
    if (shown < all.size()) {
      lines.add(before + "and " + (all.size() - shown) + " more");
    }
  }

  /** All of it as numbers, texts, lists and maps, for JSON. Poses are in mm and rad. */
  public Map<String, Object> fields() {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put("kind", kind.toString());
    fields.put("lemma", lemma);
    fields.put("sentence", sentence);
    fields.put("headline", headline);
    fields.put("at_s", Time.seconds(atNs));
    List<Map<String, Object>> robots = new ArrayList<>();
    for (Culprit culprit : culprits) {
      Map<String, Object> robot = new LinkedHashMap<>();
      robot.put("robot", culprit.robot.name());
      Pose truth = culprit.truth;
      if (truth != null) {
        robot.put("true", pose(truth));
        robot.put("believed", pose(culprit.deviation.believed(truth)));
        robot.put("error_mm", culprit.deviation.errorMm());
      }
      robots.add(robot);
    }
    fields.put("robots", robots);
    fields.put("region", region.toString());
    fields.put("faults", faults.stream().map(InjectedFault::toString).toList());
    fields.put("cause", cause);
    fields.put("commands", commands);
    return fields;
  }

  private static List<Double> pose(Pose pose) {
    return List.of(pose.xMm(), pose.yMm(), pose.headingRad());
  }
}
