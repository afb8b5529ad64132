package org.starl.serve;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Proxy;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.eclipse.jetty.websocket.api.Callback;
import org.eclipse.jetty.websocket.api.Session;
import org.starl.cli.serve.Site;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.sim.record.Layer;
import org.starl.sim.replay.Recording;
import org.starl.sim.view.page.LivePage;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;

/** What a client of Foxglove's protocol is sent. */
class FoxgloveFeedTest {

  private static final long MS = 1_000_000;
  private static final RobotId BOT = new RobotId("bot0");

  private final List<String> texts = new ArrayList<>();
  private final List<ByteBuffer> data = new ArrayList<>();

  /** A connection that keeps what it is given; {@code reads} whether its client reads. */
  private Session session(boolean reads) {
    return (Session)
        Proxy.newProxyInstance(
            Session.class.getClassLoader(),
            new Class<?>[] {Session.class},
            (proxy, method, args) -> {
              switch (method.getName()) {
                case "sendText" -> texts.add((String) args[0]);
                case "sendBinary" ->
                    data.add(((ByteBuffer) args[0]).order(ByteOrder.LITTLE_ENDIAN));
                default -> throw new IllegalStateException(method.getName());
              }
              if (reads) {
                ((Callback) args[1]).succeed();
              }
              return null;
            });
  }

  private static Recording begun() {
    Recording recording = new Recording(Obstacles.NONE, Layer.NONE);
    recording.started(new TraceHeader("0", "wander", 7, 8, Map.of(), List.of(BOT)));
    recording.observed(new TraceEvent.Joined(0, BOT, new Pose(0, 0, 0), 150));
    return recording;
  }

  private FoxgloveFeed feed(Recording recording, boolean reads) {
    return new FoxgloveFeed(
        session(reads), new Site.Shown("x", "", recording, new LivePage(recording, 1)));
  }

  @Example
  void aClientThatReadsNothingIsSentALimitedNumberOfMessages() {
    Recording recording = begun();
    FoxgloveFeed feed = feed(recording, false);
    for (int i = 0; i < 5000; i++) {
      recording.reached(50 * MS * i);
      feed.advance(50 * MS);
    }
    assertThat(data).hasSizeLessThanOrEqualTo(512);
  }

  /** Specifications may find a violation after a later one. */
  @Property(tries = 30)
  void aPlayedRunTellsEachViolationAtItsTime(
      @ForAll @Size(min = 1, max = 8) List<@IntRange(max = 2000) Integer> timesMs) {
    texts.clear();
    data.clear();
    Recording recording = begun();
    recording.reached(2000 * MS);
    for (int ms : timesMs) {
      recording.violated(
          new SpecReport.Violation("Exclusive", ms * MS, List.of(BOT), "x" + ms + "x"));
    }
    recording.over(2000 * MS);
    FoxgloveFeed feed = feed(recording, true);
    feed.advance(0);
    int log = 0;
    for (String text : texts) {
      log += text.contains("\"advertise\"") && log >= 0 ? 1 : 0;
      if (text.contains("\"/log\"")) {
        break;
      }
    }
    feed.received(
        "{\"op\":\"subscribe\",\"subscriptions\":[{\"id\":1,\"channelId\":" + log + "}]}");
    for (int nowMs = 0; nowMs <= 2000; nowMs += 50) {
      feed.advance(50 * MS);
      String all = String.join("\n", data.stream().map(FoxgloveFeedTest::text).toList());
      for (int ms : timesMs) {
        assertThat(all.contains("x" + ms + "x"))
            .as("%s ms at %s ms", ms, nowMs)
            .isEqualTo(ms <= nowMs + 50);
      }
    }
  }

  private static String text(ByteBuffer message) {
    return StandardCharsets.UTF_8.decode(message.duplicate()).toString();
  }
}
