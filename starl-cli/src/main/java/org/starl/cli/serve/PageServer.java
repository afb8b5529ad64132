package org.starl.cli.serve;

import java.io.IOException;
import java.util.List;
import java.util.ServiceLoader;

/**
 * Serves a {@link Site} to browsers. Found by {@link ServiceLoader}, so the command line depends on no
 * server.
 */
public interface PageServer {

  /**
   * The address to listen at, and the pages that may connect.
   *
   * @param host a name or an address of this machine
   * @param port 0 for any that is free
   * @param token that each request must have; empty for none
   * @param origins of pages that may connect besides the server's own: {@code https://host}
   */
  record Access(String host, int port, String token, List<String> origins) {

    public Access {
      origins = List.copyOf(origins);
    }
  }

  /** A server that listens. */
  interface Running extends AutoCloseable {

    int port();

    /** Ends all connections. */
    @Override
    void close();
  }

  /**
   * Starts to listen.
   *
   * @throws IOException if that address cannot be used; its message is one line
   */
  Running start(Access access, Site site) throws IOException;
}
