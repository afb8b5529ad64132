package org.starl.ros2;

import java.io.IOException;
import java.nio.ByteBuffer;
import us.ihmc.idl.CDR;
import us.ihmc.idl.InterchangeSerializer;
import us.ihmc.pubsub.TopicDataType;
import us.ihmc.pubsub.common.SerializedPayload;

/** A type for the DDS library whose values are bytes; a received one is put into an array of one. */
final class RawType implements TopicDataType<Object> {

  private final RosType type;

  RawType(RosType type) {
    this.type = type;
  }

  @Override
  public void serialize(Object data, SerializedPayload payload) throws IOException {
    byte[] bytes = (byte[]) data;
    if (bytes.length > type.mostBytes()) {
      throw new IOException(
          type + ": " + bytes.length + " bytes; expected up to " + type.mostBytes());
    }
    payload.getData().put(bytes).flip();
    payload.setEncapsulation(SerializedPayload.CDR_LE);
    payload.setLength(bytes.length);
  }

  @Override
  public void deserialize(SerializedPayload payload, Object data) {
    ByteBuffer from = payload.getData();
    byte[] bytes = new byte[from.remaining()];
    from.get(bytes);
    ((byte[][]) data)[0] = bytes;
  }

  @Override
  public int getTypeSize() {
    return type.mostBytes();
  }

  @Override
  public String getName() {
    return type.ddsName();
  }

  @Override
  public Object createData() {
    return new byte[1][];
  }

  @Override
  public TopicDataType<Object> newInstance() {
    return new RawType(type);
  }

  @Override
  public void serialize(Object data, InterchangeSerializer serializer) {
    throw new UnsupportedOperationException("bytes alone");
  }

  @Override
  public void deserialize(InterchangeSerializer serializer, Object data) {
    throw new UnsupportedOperationException("bytes alone");
  }

  @Override
  public void serialize(Object data, CDR cdr) {
    throw new UnsupportedOperationException("bytes alone");
  }

  @Override
  public void deserialize(Object data, CDR cdr) {
    throw new UnsupportedOperationException("bytes alone");
  }

  @Override
  public void copy(Object from, Object to) {
    throw new UnsupportedOperationException("bytes alone");
  }
}
