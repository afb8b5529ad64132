package org.starl.sim.export;

/** Takes messages on topics, each topic with a JSON schema: a file, or a connection. */
public interface MessageSink {

  /** Opens a channel; returns its number, for {@link #message}. */
  int channel(String topic, String schemaName, String jsonSchema);

  /**
   * Takes a message.
   *
   * @param timeNs from the start of the run; does not decrease
   * @param json in UTF-8
   */
  void message(int channel, long timeNs, byte[] json);
}
