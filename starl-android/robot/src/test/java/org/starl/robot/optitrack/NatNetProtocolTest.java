package org.starl.robot.optitrack;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Fix;
import org.starl.geometry.Pose;

/** What the client says, when, and what it makes of what it hears; in virtual time. */
class NatNetProtocolTest {

  private static final long MS = 1_000_000;
  private static final long S = 1000 * MS;

  /** A clock that ticks ten million times a second, and began long before ours. */
  private static final long TICKS_PER_S = 10_000_000;

  private static final long OFF_TICKS = 77_000 * TICKS_PER_S;

  private final List<byte[]> sent = new ArrayList<>();
  private final List<List<TrackedBody>> heard = new ArrayList<>();
  private final List<String> lines = new ArrayList<>();
  private final Tally tally = new Tally((timeNs, level, tag, line) -> lines.add(line), "test");
  private NatNetProtocol protocol = protocol(NatNetSettings.unicast(Loopback.HOST));
  private long nowNs = 5 * S;
  private int frames;

  private NatNetProtocol protocol(NatNetSettings settings) {
    return new NatNetProtocol(
        new NatNetSettings(
            settings.server(),
            settings.group(),
            null,
            new Axes(UpAxis.Z, BodyAxis.PLUS_X),
            settings.bounds()),
        tally,
        sent::add,
        heard::add);
  }

  private static long ticks(long ourNs) {
    return OFF_TICKS + ourNs / (S / TICKS_PER_S);
  }

  private static RigidBodyState at(int id, double xM, boolean isTracked) {
    return new RigidBodyState(id, xM, 0, 0, 0, 0, 0, 1, 0.001, isTracked);
  }

  private void receive(byte[] datagram) {
    protocol.received(datagram, datagram.length, nowNs);
  }

  private void introduce(NatNetVersion version, long ticksPerS) {
    receive(
        new ServerInfo("Motive", version, ticksPerS, false, 1511, 0)
            .datagram(new LittleEndianWriter()));
  }

  private void describe(String... names) {
    LittleEndianWriter out = new LittleEndianWriter().begin(Message.MODELS).i32(names.length);
    for (int i = 0; i < names.length; i++) {
      out.i32(Description.RIGID_BODY);
      int start = out.beginSection(true);
      out.name(names[i]).i32(i + 1).i32(-1).zeros(32);
      out.endSection(start);
    }
    receive(out.end());
  }

  /** The server got it 1 ms after it was sent, and answers within another. */
  private void answerEcho() {
    byte[] last = sent.get(sent.size() - 1);
    LittleEndianReader question = Message.payload(last, last.length);
    assertThat(Message.id(last, last.length)).isEqualTo(Message.ECHO_REQUEST);
    long stamp = question.i64();
    nowNs += 2 * MS;
    receive(
        new LittleEndianWriter()
            .begin(Message.ECHO_RESPONSE)
            .i64(stamp)
            .i64(ticks(nowNs - MS))
            .end());
  }

  /** Exposed {@code ageMs} ago, sent 1 ms ago. */
  private void frame(long ageMs, RigidBodyState... bodies) {
    frame(ticks(nowNs - ageMs * MS), ticks(nowNs - MS), bodies);
  }

  private void frame(long exposedTicks, long sentTicks, RigidBodyState... bodies) {
    frames++;
    LittleEndianWriter out = new LittleEndianWriter().begin(Message.FRAME).i32(frames);
    out.i32(0).i32(0).i32(0).i32(0).i32(bodies.length);
    int start = out.beginSection(true);
    for (RigidBodyState body : bodies) {
      body.write(out);
    }
    out.endSection(start);
    out.zeros(5 * 8).zeros(16).i64(exposedTicks).i64(0).i64(sentTicks).zeros(8).u16(0).i32(0);
    receive(out.end());
  }

  private void connect() {
    introduce(NatNetVersion.V4_1, TICKS_PER_S);
    describe("bot0", "bot1");
    protocol.tick(nowNs);
    answerEcho();
    sent.clear();
  }

  private List<Integer> sentIds() {
    List<Integer> ids = new ArrayList<>();
    for (byte[] each : sent) {
      ids.add(Message.id(each, each.length));
    }
    sent.clear();
    return ids;
  }

  private Fix onlyFix() {
    assertThat(heard).hasSize(1);
    assertThat(heard.get(0)).hasSize(1);
    return heard.get(0).get(0).fix();
  }

  @Test
  void theClientRepeatsTheLongConnectMessageUntilAnAnswer() {
    protocol.tick(nowNs);
    protocol.tick(nowNs + NatNetProtocol.RETRY_NS - 1);
    assertThat(sent).hasSize(1);
    protocol.tick(nowNs + NatNetProtocol.RETRY_NS);
    assertThat(sent.get(1)).hasSize(4 + 270).startsWith(0, 0, 14, 1, 'P', 'i', 'n', 'g', 0);
    assertThat(sentIds()).containsExactly(Message.CONNECT, Message.CONNECT);
    introduce(NatNetVersion.V4_1, TICKS_PER_S);
    protocol.tick(nowNs);
    assertThat(sentIds())
        .containsExactly(Message.REQUEST_MODELS, Message.KEEP_ALIVE, Message.ECHO_REQUEST);
    describe("bot0");
    nowNs += NatNetProtocol.CONFIRM_NS;
    protocol.tick(nowNs);
    assertThat(sentIds())
        .containsExactly(Message.REQUEST_MODELS, Message.KEEP_ALIVE, Message.ECHO_REQUEST);
    describe("bot0");
    nowNs += S;
    protocol.tick(nowNs);
    assertThat(sentIds()).containsExactly(Message.KEEP_ALIVE, Message.ECHO_REQUEST);
  }

  @Test
  void aGroupNeedsNoKeepAlive() {
    protocol = protocol(NatNetSettings.multicast(Loopback.HOST));
    connect();
    for (int i = 0; i < 20; i++) {
      nowNs += 100 * MS;
      frame(5, at(1, 1, true));
      protocol.tick(nowNs);
    }
    assertThat(sentIds()).doesNotContain(Message.KEEP_ALIVE).contains(Message.ECHO_REQUEST);
  }

  @Test
  void aFixHasItsExposureTimeAndABoundThatIncludesItsUncertainty() {
    connect();
    nowNs += 10 * MS;
    long exposedNs = nowNs - 9 * MS;
    frame(9, at(2, 1.5, true));
    Fix fix = onlyFix();
    assertThat(heard.get(0).get(0).name()).isEqualTo("bot1");
    assertThat(fix.pose()).isEqualTo(new Pose(1500, 0, 0));
    // The answer took 2 ms: the clock is known to 1 ms either way, in which a robot drives 0.5 mm.
    assertThat(Math.abs(fix.timeNs() - exposedNs)).isLessThanOrEqualTo(1_001_000);
    assertThat(fix.errorMm()).isBetween(5.0, 5.51);
    assertThat(fix.errorRad()).isBetween(0.0375, 0.0375 + 0.0044);
  }

  @Test
  void theMeanErrorOfTheMarkersWidensTheBound() {
    connect();
    frame(5, new RigidBodyState(1, 0, 0, 0, 0, 0, 0, 1, 0.004, true));
    assertThat(onlyFix().errorMm()).isBetween(12.0, 12.51);
    assertThat(onlyFix().errorRad()).isBetween(0.15, 0.16);
  }

  @Test
  void withoutAnExposureTimeTheAssumedLatencyWidensTheBound() {
    connect();
    frame(0, ticks(nowNs - MS), at(1, 1, true));
    Fix fix = onlyFix();
    // 30 ms of latency: 15 ms either way.
    assertThat(fix.timeNs()).isBetween(nowNs - 18 * MS, nowNs - 15 * MS);
    assertThat(fix.errorMm()).isBetween(5 + 7.5, 5 + 8.1);
  }

  @Test
  void withoutAnyTimeTheAssumedDelayIsAdded() {
    introduce(NatNetVersion.V4_1, 0);
    describe("bot0");
    frame(0, 0, at(1, 1, true));
    assertThat(onlyFix().timeNs()).isEqualTo(nowNs - 25 * MS);
    assertThat(onlyFix().errorMm()).isEqualTo(5 + 12.5);
  }

  @Test
  void withoutAnswersTheClockIsTrustedAfterAWhile() {
    introduce(NatNetVersion.V4_1, TICKS_PER_S);
    describe("bot0");
    frame(5, at(1, 1, true));
    assertThat(heard).isEmpty();
    nowNs += ClockMap.SETTLE_NS;
    frame(5, at(1, 1, true));
    assertThat(onlyFix().timeNs()).isBetween(nowNs - 16 * MS, nowNs - 4 * MS);
    assertThat(tally.statistics().dropped(FeedDrop.EARLY)).isEqualTo(1);
  }

  @Test
  void aLostBodyHasNoFix() {
    connect();
    frame(5, at(1, 1, false));
    assertThat(onlyFix()).isNull();
    assertThat(tally.statistics().dropped(FeedDrop.LOST)).isEqualTo(1);
  }

  @Test
  void staleAndOutdatedFramesAreDropped() {
    connect();
    nowNs += S;
    frame(20, at(1, 1, true));
    frame(30, at(1, 2, true));
    assertThat(heard.get(1).get(0).fix()).isNull();
    frame(300, at(1, 3, true));
    assertThat(heard).hasSize(2);
    assertThat(tally.statistics().dropped(FeedDrop.OUTDATED)).isEqualTo(1);
    assertThat(tally.statistics().dropped(FeedDrop.STALE)).isEqualTo(1);
    frame(ticks(nowNs + S), ticks(nowNs + S), at(1, 1, true));
    assertThat(tally.statistics().dropped(FeedDrop.IMPLAUSIBLE)).isEqualTo(1);
  }

  @Test
  void impossiblePosesGiveNoFix() {
    connect();
    frame(5, new RigidBodyState(1, Double.NaN, 0, 0, 0, 0, 0, 1, 0, true));
    frame(4, new RigidBodyState(1, 0, 0, 0, 0, 0, 0, 1, -1, true));
    frame(3, new RigidBodyState(1, 0, 0, 0, 0, 0, 0, 1, Double.NaN, true));
    assertThat(heard).allMatch(bodies -> bodies.get(0).fix() == null).hasSize(3);
    assertThat(tally.statistics().dropped(FeedDrop.IMPLAUSIBLE)).isEqualTo(3);
    assertThat(lines).filteredOn(line -> line.contains("IMPLAUSIBLE")).hasSize(1);
  }

  @Test
  void duplicateNumbersOrNamesGiveNoFix() {
    connect();
    frame(5, at(1, 1, true), at(2, 2, true), at(1, 3, true));
    assertThat(heard.get(0)).extracting(TrackedBody::name).containsExactly("bot1");
    describe("bot0", "bot0", "bot2");
    nowNs += NatNetProtocol.CONFIRM_NS;
    describe("bot0", "bot0", "bot2");
    frame(4, at(1, 1, true), at(2, 2, true), at(3, 3, true));
    assertThat(heard.get(1)).extracting(TrackedBody::name).containsExactly("bot2");
    assertThat(tally.statistics().dropped(FeedDrop.AMBIGUOUS)).isEqualTo(4);
  }

  @Test
  void theDescriptionOfAnUnknownBodyIsRequested() {
    connect();
    frame(5, at(3, 1, true));
    assertThat(heard.get(0)).isEmpty();
    nowNs += NatNetProtocol.RETRY_NS;
    protocol.tick(nowNs);
    assertThat(sentIds()).contains(Message.REQUEST_MODELS);
  }

  @Test
  void aServerThatIsTooOldIsReported() {
    introduce(new NatNetVersion(2, 9), TICKS_PER_S);
    assertThat(protocol.isConnected()).isFalse();
    assertThat(lines).hasSize(1).allMatch(line -> line.contains("expected 3.0 or later"));
  }

  @Test
  void theClientReconnectsAfterSilence() {
    connect();
    nowNs += NatNetProtocol.SILENCE_NS;
    protocol.tick(nowNs);
    assertThat(protocol.isConnected()).isTrue();
    nowNs += MS;
    protocol.tick(nowNs);
    assertThat(protocol.isConnected()).isFalse();
    assertThat(sentIds()).containsOnlyOnce(Message.CONNECT);
  }

  @Test
  void theClientReconnectsWithoutFramesEvenIfTheServerAnswers() {
    connect();
    for (int i = 0; i < 35; i++) {
      nowNs += 98 * MS;
      protocol.tick(nowNs);
      if (Message.id(sent.get(sent.size() - 1), 4) == Message.ECHO_REQUEST) {
        answerEcho();
      }
    }
    assertThat(protocol.isConnected()).isTrue();
    assertThat(sentIds()).contains(Message.CONNECT);
  }

  @Test
  void unrequestedAndDuplicateAnswersAreIgnored() {
    connect();
    receive(
        new LittleEndianWriter()
            .begin(Message.ECHO_RESPONSE)
            .i64(nowNs - 2 * MS)
            .i64(ticks(nowNs) + TICKS_PER_S)
            .end());
    frame(5, at(1, 1, true));
    assertThat(onlyFix().timeNs()).isBetween(nowNs - 6 * MS - MS, nowNs - 4 * MS + MS);
  }

  @Test
  void framesBeforeTheServerIsKnownAreCountedAsEarly() {
    frame(5, at(1, 1, true));
    receive(new LittleEndianWriter().begin(77).end());
    receive(new LittleEndianWriter().begin(Message.CONNECT).end());
    receive(new byte[] {7, 0, 9, 0, 1});
    assertThat(heard).isEmpty();
    assertThat(tally.statistics().dropped(FeedDrop.EARLY)).isEqualTo(1);
    assertThat(tally.statistics().dropped(FeedDrop.UNKNOWN)).isEqualTo(2);
    assertThat(tally.statistics().dropped(FeedDrop.MALFORMED)).isEqualTo(1);
  }

  /** Runs for this time with a frame each 10 ms; the server answers all questions. */
  private void serve(long ms, String... names) {
    for (long endNs = nowNs + ms * MS; nowNs < endNs; nowNs += 10 * MS) {
      frame(2, at(1, 1, true), at(2, 2, true));
      int before = sent.size();
      protocol.tick(nowNs);
      for (byte[] question : List.copyOf(sent.subList(before, sent.size()))) {
        switch (Message.id(question, question.length)) {
          case Message.REQUEST_MODELS -> describe(names);
          case Message.CONNECT -> introduce(NatNetVersion.V4_1, TICKS_PER_S);
          case Message.ECHO_REQUEST -> answer(question, 0);
          default -> {
            // not answered
          }
        }
      }
    }
  }

  private void answer(byte[] question, long falseTicks) {
    long stamp = Message.payload(question, question.length).i64();
    receive(
        new LittleEndianWriter()
            .begin(Message.ECHO_RESPONSE)
            .i64(stamp)
            .i64(ticks(nowNs) + falseTicks)
            .end());
  }

  /** The place of a body in the last message, in mm; null if it has no fix. */
  private @Nullable Double xMm(String name) {
    for (TrackedBody body : heard.isEmpty() ? List.<TrackedBody>of() : heard.getLast()) {
      if (body.name().equals(name) && body.fix() != null) {
        return body.fix().pose().xMm();
      }
    }
    return null;
  }

  private void assertTrueFixes() {
    assertThat(nowNs - heard.getLast().get(0).fix().timeNs()).isLessThan(50 * MS);
    assertThat(xMm("bot0")).isEqualTo(1000);
    assertThat(xMm("bot1")).isEqualTo(2000);
  }

  @Test
  void descriptionsOfAnotherServerChangeNothingWhileFramesCome() {
    connect();
    serve(2000, "bot0", "bot1");
    for (int i = 0; i < 7; i++) {
      introduce(NatNetVersion.V3_0, TICKS_PER_S);
      introduce(NatNetVersion.V4_1, 2 * TICKS_PER_S);
      heard.clear();
      serve(300, "bot0", "bot1");
      assertThat(heard).hasSize(30);
      assertTrueFixes();
    }
    assertThat(lines).filteredOn(line -> line.contains("is not believed")).hasSize(2);
  }

  @Test
  void anotherServerIsBelievedAfterSilence() {
    connect();
    serve(1000, "bot0", "bot1");
    nowNs += NatNetProtocol.SILENCE_NS + MS;
    introduce(NatNetVersion.V3_0, TICKS_PER_S);
    assertThat(lines).anyMatch(line -> line.contains("connected to Motive, NatNet 3.0"));
  }

  @Test
  void aFalseTickRateAtTheStartGivesNoFixesUntilTheTrueOneIsAskedFor() {
    introduce(NatNetVersion.V4_1, 2 * TICKS_PER_S);
    serve(1000, "bot0", "bot1");
    assertThat(lines).anyMatch(line -> line.contains("clock contradict each other"));
    heard.clear();
    serve(1000, "bot0", "bot1");
    assertThat(heard).isEmpty();
    serve(8000, "bot0", "bot1");
    assertTrueFixes();
  }

  @Test
  void modelsThatSwapTwoNamesAreAskedForAgain() {
    connect();
    serve(2000, "bot0", "bot1");
    describe("bot1", "bot0");
    for (int i = 0; i < 300; i++) {
      serve(10, "bot0", "bot1");
      assertThat(xMm("bot0")).isIn(null, 1000.0);
    }
    assertTrueFixes();
    assertThat(lines).filteredOn(line -> line.contains("asking again")).hasSize(1);
  }

  @Test
  void modelsThatAreForgedAgainAndAgainStopTheRobotsThatTheySwap() {
    introduce(NatNetVersion.V4_1, TICKS_PER_S);
    describe("bot1", "bot0");
    serve(200, "bot0", "bot1");
    heard.clear();
    for (int i = 0; i < 50; i++) {
      describe("bot1", "bot0");
      serve(100, "bot0", "bot1");
      describe("bot1", "bot0");
      assertThat(xMm("bot0")).isNull();
    }
    serve(3000, "bot0", "bot1");
    assertTrueFixes();
  }

  @Test
  void newModelsCountOnceAllAnswersAreEqual() {
    connect();
    serve(2000, "bot0", "bot1");
    describe("bot0", "other");
    serve(2000, "bot0", "other");
    assertThat(heard.getLast()).extracting(TrackedBody::name).containsExactly("bot0", "other");
  }

  @Test
  void falseAnswersAboutTheClockAreIgnoredOrStopAllFixes() {
    connect();
    serve(2000, "bot0", "bot1");
    sent.clear();
    protocol.tick(nowNs += NatNetProtocol.ECHO_NS);
    byte[] question = sent.getLast();
    for (long falseMs : new long[] {-100, 100}) {
      answer(question, falseMs * TICKS_PER_S / 1000);
      heard.clear();
      serve(500, "bot0", "bot1");
      assertThat(heard).hasSize(50);
      assertTrueFixes();
    }
    for (int i = 0; i < 5; i++) {
      answer(question, TICKS_PER_S / 10);
      serve(1000, "bot0", "bot1");
      question = lastQuestion();
      answer(question, TICKS_PER_S / 10);
    }
    heard.clear();
    serve(500, "bot0", "bot1");
    assertThat(heard).isEmpty();
    serve(8000, "bot0", "bot1");
    assertTrueFixes();
  }

  private byte[] lastQuestion() {
    List<byte[]> questions = new ArrayList<>(sent);
    questions.removeIf(each -> Message.id(each, each.length) != Message.ECHO_REQUEST);
    return questions.getLast();
  }
}
