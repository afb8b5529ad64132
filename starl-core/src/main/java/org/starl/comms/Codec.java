package org.starl.comms;

/**
 * The bytes of one channel's messages. {@code read(write(m))} equals {@code m}; {@code read} throws
 * {@link WireFormatException} on anything that {@code write} cannot have written, as {@link
 * WireReader} does of itself. An {@link IllegalArgumentException}, with which a value's constructor
 * refuses its arguments, counts as the same.
 */
public interface Codec<T> {

  void write(T message, WireWriter out);

  T read(WireReader in);
}
