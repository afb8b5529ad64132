package org.starl.cli.report;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.LongFunction;
import java.util.stream.LongStream;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Plan;
import org.starl.sim.Diagnosis;
import org.starl.sim.Failure;
import org.starl.sim.SimResult;
import org.starl.sim.check.RunOutcome;
import org.starl.sim.record.Filmstrip;
import org.starl.sim.record.Filmstrip.Frame;
import org.starl.sim.record.PictureRecorder;
import org.starl.sim.record.PictureTime;
import org.starl.sim.replay.Recording;
import org.starl.sim.view.page.RunPage;
import org.starl.sim.view.page.SequenceChart;
import org.starl.time.Time;

/**
 * One run of a campaign, run again to get its story and pictures.
 *
 * @param story in lines; empty if an exception ended the run
 * @param shots ordered by time
 * @param chart a message sequence chart of the events before the problem, as a data URL; empty if
 *     there is none
 * @param page an HTML page that plays the seconds around the problem; empty if there is none
 * @param outcome how it ended this time
 * @param diagnoses why robots waited, by the missed deadline, or {@link #AT_THE_END}
 * @param failure what went wrong; null if nothing did
 */
public record IllustratedRun(
    long seed,
    List<String> story,
    List<Shot> shots,
    String chart,
    String page,
    RunOutcome outcome,
    Map<String, Diagnosis> diagnoses,
    @Nullable Failure failure) {

  /** The key of an unfinished run's diagnosis. */
  static final String AT_THE_END = "at the end";

  private static final int FLOOR_PX = 440;
  private static final int WHOLE_PX = 1100;

  /** Pictures this many seconds before the problem. */
  private static final long[] BEFORE_S = {8, 4, 2, 1, 0};

  /** What the page plays before and after the problem: some 40 KB for four robots. */
  private static final long PLAYED_BEFORE_NS = 30 * Time.NS_PER_S;

  private static final long PLAYED_AFTER_NS = 2 * Time.NS_PER_S;

  /**
   * A picture as a data URL.
   *
   * @param timeNs since the start of the run; -1 if the picture shows its time itself
   * @param isWhole whether it has the legend, not only the floor
   */
  record Shot(long timeNs, boolean isWhole, String address) {}

  /**
   * Runs a seed again, with pictures of {@code momentNs} and the seconds before it.
   *
   * @param plans makes the plan, including its carriers; an exception counts as a failed run
   * @param momentNs the run's end if it is later
   */
  public static IllustratedRun of(long seed, LongFunction<Plan> plans, long momentNs) {
    List<Shot> shots = new ArrayList<>();
    String page = "";
    Failure failure = null;
    SequenceChart chart = new SequenceChart();
    try {
      Plan plan = plans.apply(seed);
      Filmstrip film = new Filmstrip(plan.obstacles(), plan.layer(), timesNs(momentNs));
      Recording recording = new Recording(plan.obstacles(), plan.layer().copy());
      plan.simulation().observer(film).observer(recording).observer(chart);
      try {
        SimResult result = plan.simulation().build().run();
        page = page(recording, momentNs);
        return new IllustratedRun(
            seed,
            story(plan, result),
            shots(film),
            address(chart),
            page,
            RunOutcome.of(result),
            diagnoses(result),
            result.failure());
      } catch (RuntimeException e) {
        shots = shots(film);
        recording.failed(RunOutcome.failed(e).detail());
        failure = recording.wentWrong();
        page = page(recording, momentNs);
        throw e;
      }
    } catch (RuntimeException e) {
      RunOutcome outcome = RunOutcome.failed(e);
      chart.end(outcome.detail());
      return new IllustratedRun(
          seed, List.of(), shots, address(chart), page, outcome, Map.of(), failure);
    }
  }

  /** With a line for each fault. */
  private static List<String> story(Plan plan, SimResult result) {
    List<String> story = new ArrayList<>(plan.story().lines());
    result.faults().forEach(fault -> story.add("fault: " + fault));
    return story;
  }

  /** Runs a seed again, with a picture of the moment that shows most. */
  public static IllustratedRun best(long seed, LongFunction<Plan> plans) {
    Plan plan = plans.apply(seed);
    PictureRecorder recorder =
        new PictureRecorder(plan.obstacles(), plan.layer(), new PictureTime.Best());
    plan.simulation().observer(recorder);
    RunOutcome outcome = RunOutcome.of(plan.simulation().build().run());
    Shot shot = new Shot(-1, true, address(recorder::writePng));
    return new IllustratedRun(
        seed, plan.story().lines(), List.of(shot), "", "", outcome, Map.of(), null);
  }

  private static Map<String, Diagnosis> diagnoses(SimResult result) {
    Map<String, Diagnosis> diagnoses = new LinkedHashMap<>();
    result
        .diagnoses()
        .forEach((violation, diagnosis) -> diagnoses.put(violation.toString(), diagnosis));
    if (!result.isFinished()) {
      diagnoses.put(AT_THE_END, result.diagnosis());
    }
    return diagnoses;
  }

  private static String page(Recording recording, long momentNs) {
    if (!recording.hasBegun()) {
      return "";
    }
    long aboutNs = Math.min(momentNs, recording.endNs());
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try {
      new RunPage(
              recording, RunPage.EVERY_NS, aboutNs - PLAYED_BEFORE_NS, aboutNs + PLAYED_AFTER_NS)
          .write(bytes);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return bytes.toString(StandardCharsets.UTF_8);
  }

  private static List<Long> timesNs(long momentNs) {
    return LongStream.of(BEFORE_S)
        .map(beforeS -> momentNs - beforeS * Time.NS_PER_S)
        .filter(timeNs -> timeNs >= 0)
        .boxed()
        .toList();
  }

  private static List<Shot> shots(Filmstrip film) {
    film.cut();
    List<Shot> shots = new ArrayList<>();
    for (int i = 0; i < film.frames().size(); i++) {
      Frame frame = film.frames().get(i);
      boolean isWhole = i == film.frames().size() - 1;
      Png png =
          isWhole
              ? out -> frame.writePng(WHOLE_PX, out)
              : out -> frame.writeFloorPng(FLOOR_PX, out);
      shots.add(new Shot(frame.timeNs(), isWhole, address(png)));
    }
    return shots;
  }

  private interface Png {
    void write(OutputStream out) throws IOException;
  }

  private static String address(SequenceChart chart) {
    return chart.isEmpty()
        ? ""
        : "data:image/svg+xml;base64,"
            + Base64.getEncoder().encodeToString(chart.svg().getBytes(StandardCharsets.UTF_8));
  }

  private static String address(Png png) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try {
      png.write(bytes);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return "data:image/png;base64," + Base64.getEncoder().encodeToString(bytes.toByteArray());
  }
}
