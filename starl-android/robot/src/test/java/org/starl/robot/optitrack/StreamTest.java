package org.starl.robot.optitrack;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.BufferUnderflowException;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.starl.geometry.Pose;

/** What is read from frames and descriptions, byte by byte. */
class StreamTest {

  private static final RigidBodyState ONE = new RigidBodyState(11, 1, 2, 3, 0, 0, 0, 1, 0.5, true);
  private static final RigidBodyState OTHER =
      new RigidBodyState(-12, -1, 0.25, 1e-3f, 0.5, 0.5, -0.5, 0.5, 0, false);

  static List<NatNetVersion> versions() {
    return FullStream.VERSIONS;
  }

  static List<NatNetVersion> servedVersions() {
    return NatNetServerSettings.VERSIONS;
  }

  private static MocapFrame parse(byte[] datagram, NatNetVersion version) {
    return orNull(datagram, datagram.length, in -> FrameParser.parse(in, version));
  }

  private static Models models(byte[] datagram, NatNetVersion version) {
    return orNull(datagram, datagram.length, in -> Models.parse(in, version));
  }

  /** What a parser makes of a datagram's payload; null if it refuses it. */
  static <T> T orNull(byte[] datagram, int length, Function<LittleEndianReader, T> parser) {
    try {
      return parser.apply(Message.payload(datagram, length));
    } catch (BufferUnderflowException refused) {
      return null;
    }
  }

  @ParameterizedTest
  @MethodSource("versions")
  void bodiesAreFoundAmongAllPartsOfAFrame(NatNetVersion version) {
    byte[] datagram = new FullStream(version).frame(42, List.of(ONE, OTHER));
    assertThat(parse(datagram, version))
        .isEqualTo(new MocapFrame(List.of(ONE, OTHER), 1000, 2000, 3000, true));
  }

  @ParameterizedTest
  @MethodSource("versions")
  void namesAreFoundAmongAllDescriptions(NatNetVersion version) {
    Models models = models(new FullStream(version).models(), version);
    assertThat(models.isWhole()).isTrue();
    assertThat(models).hasToString("[Ännchen, bot1]");
    assertThat(models.name(11)).isEqualTo("Ännchen");
    assertThat(models.name(12)).isEqualTo("bot1");
    assertThat(models.name(1)).isNull();
  }

  @ParameterizedTest
  @MethodSource("versions")
  void truncatedFramesAndDescriptionsAreRefused(NatNetVersion version) {
    byte[] frame = new FullStream(version).frame(42, List.of(ONE, OTHER));
    int marksTheEnd = 4;
    for (int length = 0; length < frame.length - marksTheEnd; length++) {
      assertThat(parse(resized(frame, length), version)).as("%d bytes", length).isNull();
    }
    byte[] models = new FullStream(version).models();
    for (int length = 0; length < models.length; length++) {
      assertThat(models(resized(models, length), version)).as("%d bytes", length).isNull();
    }
  }

  /** The header says that this is all. */
  private static byte[] resized(byte[] datagram, int length) {
    byte[] cut = Arrays.copyOf(datagram, length);
    if (length >= Message.HEADER_BYTES) {
      cut[2] = (byte) (length - Message.HEADER_BYTES);
      cut[3] = (byte) ((length - Message.HEADER_BYTES) >> 8);
    }
    return cut;
  }

  @Test
  void aHeaderWithTooLargeALengthIsRefused() {
    byte[] frame = new FullStream(NatNetVersion.V4_1).frame(1, List.of(ONE));
    assertThat(StreamTest.<Integer>orNull(frame, frame.length, LittleEndianReader::i32))
        .isNotNull();
    for (int length : new int[] {frame.length - 1, 3, 0}) {
      assertThat(StreamTest.<Integer>orNull(frame, length, LittleEndianReader::i32))
          .as("%d bytes", length)
          .isNull();
    }
    assertThat(Message.id(frame, 3)).isEqualTo(-1);
  }

  @ParameterizedTest
  @MethodSource("versions")
  void impossibleCountsAreRefusedBeforeAllocation(NatNetVersion version) {
    for (int count : new int[] {-1, Integer.MIN_VALUE, Integer.MAX_VALUE, 1_000_000}) {
      LittleEndianWriter out = new LittleEndianWriter().begin(Message.FRAME).i32(1);
      out.i32(0);
      out.endSection(out.beginSection(version.tellsSizes()));
      out.i32(0);
      out.endSection(out.beginSection(version.tellsSizes()));
      out.i32(count);
      int start = out.beginSection(version.tellsSizes());
      ONE.write(out);
      out.endSection(start);
      assertThat(parse(out.zeros(200).end(), version)).isNull();
      byte[] models = new LittleEndianWriter().begin(Message.MODELS).i32(count).zeros(50).end();
      assertThat(models(models, version)).isNull();
    }
  }

  @Test
  void aLaterVersionMayLengthenBodiesAndAppendSections() {
    NatNetVersion later = new NatNetVersion(4, 7);
    LittleEndianWriter out = new LittleEndianWriter().begin(Message.FRAME).i32(3);
    out.i32(0).i32(0).i32(0).i32(0);
    out.i32(2);
    int start = out.beginSection(true);
    ONE.write(out);
    out.zeros(7);
    OTHER.write(out);
    out.zeros(7);
    out.endSection(start);
    for (int section = 0; section < 5; section++) {
      out.i32(0).i32(0);
    }
    out.i32(9).i32(33).zeros(33);
    out.i32(1).i32(0);
    out.i32(0).i32(0).f64(1).i64(4).i64(5).i64(6).i32(0).i32(0).u16(0).i32(0);
    assertThat(parse(out.end(), later))
        .isEqualTo(new MocapFrame(List.of(ONE, OTHER), 4, 5, 6, false));
  }

  @Test
  void anUnknownDescriptionIsSkippedIfItsSizeIsKnownAndEndsTheListOtherwise() {
    for (NatNetVersion version : FullStream.VERSIONS) {
      LittleEndianWriter out = new LittleEndianWriter().begin(Message.MODELS).i32(2);
      out.i32(77);
      int start = out.beginSection(version.tellsSizes());
      out.zeros(13);
      out.endSection(start);
      out.i32(Description.RIGID_BODY);
      start = out.beginSection(version.tellsSizes());
      out.name("bot0").i32(4).i32(-1).zeros(12).zeros(16).i32(0);
      out.endSection(start);
      Models models = models(out.end(), version);
      assertThat(models.isWhole()).isEqualTo(version.tellsSizes());
      assertThat(models).hasToString(version.tellsSizes() ? "[bot0]" : "[]");
    }
  }

  @Test
  void bodiesWithEqualNamesAreAmbiguous() {
    LittleEndianWriter out = new LittleEndianWriter().begin(Message.MODELS).i32(3);
    List<String> names = List.of("bot0", "bot1", "bot0");
    for (int id = 0; id < names.size(); id++) {
      out.i32(Description.RIGID_BODY);
      int start = out.beginSection(true);
      out.name(names.get(id)).i32(id);
      out.endSection(start);
    }
    Models models = models(out.end(), NatNetVersion.V4_1);
    assertThat(models.isAmbiguous("bot0")).isTrue();
    assertThat(models.isAmbiguous("bot1")).isFalse();
  }

  @ParameterizedTest
  @MethodSource("servedVersions")
  void theServersFramesAndDescriptionsAreRead(NatNetVersion version) {
    StreamEncoder encoder = new StreamEncoder(version, Axes.DEFAULT);
    PoseSource.Body body = new PoseSource.Body("bot0", new Pose(1000, -2000, 0), true, 2);
    PoseSource.Snapshot snapshot = new PoseSource.Snapshot(77, List.of(body));
    assertThat(encoder.addNew(snapshot)).isTrue();
    assertThat(encoder.addNew(snapshot)).isFalse();
    RigidBodyState state = new RigidBodyState(1, 1, 0, 2, 0, 0, 0, 1, 0.002f, true);
    assertThat(parse(encoder.frame(5, snapshot, true, 88), version))
        .isEqualTo(new MocapFrame(List.of(state), 77, 77, 88, true));
    assertThat(models(encoder.models(snapshot.bodies()), version).name(1)).isEqualTo("bot0");
  }
}
