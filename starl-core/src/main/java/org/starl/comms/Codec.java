package org.starl.comms;

/**
 * Encodes and decodes one channel's messages. {@code read(write(m))} equals {@code m}. {@code read}
 * throws {@link WireFormatException} for bytes that {@code write} cannot have written, as {@link
 * WireReader}'s methods do; an {@link IllegalArgumentException} from a value's constructor has the
 * same effect.
 */
public interface Codec<T> {

  void write(T message, WireWriter out);

  T read(WireReader in);
}
