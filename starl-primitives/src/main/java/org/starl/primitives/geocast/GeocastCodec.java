package org.starl.primitives.geocast;

import org.starl.comms.Codec;
import org.starl.comms.WireFormatException;
import org.starl.comms.WireReader;
import org.starl.comms.WireWriter;
import org.starl.geometry.Region;

/** Encodes a copy as 1, id, area, start, deadline, message; an acknowledgement as 2, id. */
final class GeocastCodec<T> implements Codec<GeocastMessage<T>> {

  private static final int COPY = 1;
  private static final int ACK = 2;

  private final Codec<T> payload;
  private final RegionCodec regions = new RegionCodec();

  GeocastCodec(Codec<T> payload) {
    this.payload = payload;
  }

  @Override
  public void write(GeocastMessage<T> message, WireWriter out) {
    switch (message) {
      case GeocastMessage.Copy<T> copy -> {
        out.u8(COPY);
        id(copy.id(), out);
        regions.write(copy.area(), out);
        out.i64(copy.startNs());
        out.i64(copy.deadlineNs());
        payload.write(copy.message(), out);
      }
      case GeocastMessage.Ack<T> ack -> {
        out.u8(ACK);
        id(ack.id(), out);
      }
    }
  }

  @Override
  public GeocastMessage<T> read(WireReader in) {
    int kind = in.u8();
    return switch (kind) {
      case COPY -> copy(in);
      case ACK -> new GeocastMessage.Ack<>(id(in));
      default -> throw new WireFormatException("geocast message of kind " + kind);
    };
  }

  private GeocastMessage<T> copy(WireReader in) {
    GeocastId id = id(in);
    Region area = regions.read(in);
    long startNs = in.i64();
    long deadlineNs = in.i64();
    if (startNs < 0 || deadlineNs <= startNs) {
      throw new WireFormatException("geocast from " + startNs + " to " + deadlineNs + " ns");
    }
    return new GeocastMessage.Copy<>(id, area, startNs, deadlineNs, payload.read(in));
  }

  private static void id(GeocastId id, WireWriter out) {
    out.process(id.origin());
    out.i64(id.number());
  }

  private static GeocastId id(WireReader in) {
    var origin = in.process();
    long number = in.i64();
    if (number <= 0) {
      throw new WireFormatException("geocast number " + number);
    }
    return new GeocastId(origin, number);
  }
}
