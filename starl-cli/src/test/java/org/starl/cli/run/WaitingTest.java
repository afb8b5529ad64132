package org.starl.cli.run;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.apps.Demos;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.cli.Cli;
import org.starl.cli.HelloWithATwist;
import org.starl.cli.report.Parsed;
import org.starl.cli.report.Report;
import org.starl.geometry.Pose;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.sim.RobotSpec;
import org.starl.spec.Monitor;
import org.starl.spec.Within;
import org.starl.trace.TraceEvent;
import org.w3c.dom.Document;
import org.w3c.dom.Element;

/** A missed deadline and an unfinished run name which robot waits for which. */
class WaitingTest {

  private static final RobotId LEFT = new RobotId("left");
  private static final RobotId RIGHT = new RobotId("right");
  private static final Demos DEMOS = new Demos(List.of(new Deadlock()));
  private static final String CAUSE = "deadlock: robots wait in a circle: left -> right -> left";

  @TempDir private Path folder;

  /** Hello, with two more robots that take two mutexes in different order. */
  private static final class Deadlock extends HelloWithATwist {
    Deadlock() {
      super("deadlock", "hello with a deadlock");
    }

    @Override
    protected Plan twist(Plan plan, Request request) {
      for (RobotId robot : List.of(LEFT, RIGHT)) {
        plan.simulation().robot(new RobotSpec(robot, new Pose(0, 0, 0), false, Taker::new));
      }
      plan.simulation().monitor(Served::new).endNs(20_000_000_000L);
      return plan;
    }
  }

  private static final class Taker extends LogicThread {
    private static final Participants BOTH = Participants.of(LEFT, RIGHT);

    private final M_Mutex first;
    private final M_Mutex second;

    Taker(GlobalVarHolder gvh) {
      super(gvh);
      M_Mutex left = new M_Mutex(gvh, "left", BOTH);
      M_Mutex right = new M_Mutex(gvh, "right", BOTH);
      boolean isLeft = gvh.id.name().equals(LEFT);
      first = isLeft ? left : right;
      second = isLeft ? right : left;
    }

    @Override
    public List<Object> callStarL() {
      first.do_mutex(List.of("S"));
      await(first::od_mutex);
      sleep(2_000);
      second.do_mutex(List.of("S"));
      await("both", second::od_mutex);
      return returnResults();
    }
  }

  /** The left robot has both after 10 s. */
  private static final class Served implements Monitor {
    private final Within<RobotId> deadline = new Within<>(10_000_000_000L);

    @Override
    public List<String> lemmas() {
      return List.of("served");
    }

    @Override
    public void observe(TraceEvent event, Report report) {
      if (event.timeNs() == 0) {
        deadline.start(LEFT, 0);
      }
      deadline.expire(
          event.timeNs(),
          (robot, sinceNs, deadlineNs) ->
              report.overdue("served", deadlineNs, List.of(robot), "not served"));
    }
  }

  private String png() {
    return folder.resolve("a.png").toString();
  }

  @Test
  void aMissedDeadlineIsPrintedWithItsDiagnosis() {
    Cli cli = Cli.run(DEMOS, "run", "deadlock", "--seed", "1", "--png", png());
    assertThat(cli.status()).isEqualTo(1);
    assertThat(cli.out())
        .containsSubsequence(
            "VIOLATED: served violated at 10.000 s by left: not served",
            "  likely cause: " + CAUSE,
            "    left waits for [right]",
            "NOT FINISHED: [left, right]",
            "  likely cause: " + CAUSE);
  }

  @Test
  void jsonHoldsTheWaits() throws IOException {
    Cli cli = Cli.run(DEMOS, "run", "deadlock", "--seed", "1", "--png", png(), "--json");
    JsonNode json = new ObjectMapper().readTree(cli.text());
    assertThat(json.get("waits").get("left").get(0).asText()).isEqualTo("right");
    JsonNode overdue = json.get("overdue").get(0);
    assertThat(overdue.get("violation").asText()).startsWith("served violated at 10.000 s");
    assertThat(overdue.get("cause").asText()).isEqualTo(CAUSE);
    assertThat(overdue.get("waits").get("right").get(0).asText()).isEqualTo("left");
  }

  private static long count(Document page, String tag, String cssClass) {
    return Parsed.elements(page, tag).stream()
        .filter(element -> element.getAttribute("class").equals(cssClass))
        .count();
  }

  @Test
  void aReportDrawsTheWaitsOfBothMoments() throws Exception {
    Path file = folder.resolve("report.html");
    Cli.run(DEMOS, "campaign", "deadlock", "--seeds", "1..1", "--report", file.toString());
    Document page = Parsed.page(Files.readString(file));
    assertThat(count(page, "figure", "waits")).isEqualTo(2);
    assertThat(count(page, "rect", "robot circle")).isEqualTo(4);
    assertThat(count(page, "path", "wait circle")).isEqualTo(4);
    Element article = Parsed.elements(page, "article").get(0);
    assertThat(article.getTextContent())
        .contains("Likely cause, served violated at 10.000 s by left: not served: " + CAUSE)
        .contains("Likely cause, at the end: " + CAUSE)
        .contains("mutex/right: requests [S]; answers missing from [right]")
        .contains("Red: robots that wait for each other in a circle.");
  }
}
