package org.starl.ros2;

import com.eprosima.xmlschemas.fastrtps_profiles.DurabilityQosKindPolicyType;
import com.eprosima.xmlschemas.fastrtps_profiles.HistoryQosKindPolicyType;
import com.eprosima.xmlschemas.fastrtps_profiles.ReliabilityQosKindPolicyType;
import com.eprosima.xmlschemas.fastrtps_profiles.TransportDescriptorType;
import java.io.IOException;
import java.nio.BufferUnderflowException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.platform.Clock;
import org.starl.platform.LogSink;
import org.starl.platform.LogSink.Level;
import org.starl.robot.create.Guard;
import org.starl.robot.file.RosTopic;
import org.starl.robot.realtime.Daemons;
import org.starl.time.Time;
import us.ihmc.pubsub.Domain;
import us.ihmc.pubsub.DomainFactory;
import us.ihmc.pubsub.attributes.CommonAttributes;
import us.ihmc.pubsub.attributes.ParticipantProfile;
import us.ihmc.pubsub.attributes.PublisherAttributes;
import us.ihmc.pubsub.attributes.SubscriberAttributes;
import us.ihmc.pubsub.common.LogLevel;
import us.ihmc.pubsub.common.MatchingInfo;
import us.ihmc.pubsub.common.SampleInfo;
import us.ihmc.pubsub.participant.Participant;
import us.ihmc.pubsub.publisher.Publisher;
import us.ihmc.pubsub.subscriber.Subscriber;
import us.ihmc.pubsub.subscriber.SubscriberListener;
import us.ihmc.tools.nativelibraries.NativeLibraryLoader;

/**
 * Ends of topics on ROS 2's network. Tells within three seconds which topic has no other end, or one with
 * another quality of service or type, and what to set. From any thread.
 *
 * <p>All nodes of a process are one participant of DDS. With several, Fast DDS may block for ever when an end is
 * removed (eProsima/Fast-DDS#6193), and no node receives more.
 */
final class RosNode implements AutoCloseable {

  private static final String TAG = "ros2";
  private static final int MOST_DOMAIN = 232;
  private static final long WATCH_NS = 100 * Time.NS_PER_MS;

  private static @Nullable Participant shared;
  private static int users;

  private final Domain domain;
  private final Participant participant;
  private final Set<Publisher> publishers = ConcurrentHashMap.newKeySet();
  private final Set<Input> inputs = ConcurrentHashMap.newKeySet();
  private final Clock clock;
  private final LogSink log;
  private final List<TopicWatch> watches = new CopyOnWriteArrayList<>();
  private final Guard guard = new Guard();
  private boolean isClosed;
  private final Thread watcher;

  /** Publishes on one topic. */
  interface Output {
    /** Sends a message; a message that finds no receiver is lost. */
    void publish(Cdr message);

    /** Whether a node receives from it. */
    boolean hasReceiver();
  }

  private RosNode(Domain domain, Participant participant, String name, Clock clock, LogSink log) {
    this.domain = domain;
    this.participant = participant;
    this.clock = clock;
    this.log = log;
    watcher = Daemons.of(name + " ros2 watch", this::watch);
  }

  /**
   * Joins the domain of {@code ROS_DOMAIN_ID}.
   *
   * @throws IOException if there is no library for this machine, or no such domain; one line
   */
  static RosNode open(String name, Clock clock, LogSink log) throws IOException {
    int domainId = domainId(System.getenv("ROS_DOMAIN_ID"));
    try {
      Domain domain = domain();
      RosNode node = new RosNode(domain, join(domain, domainId), name, clock, log);
      node.watcher.start();
      return node;
    } catch (LinkageError | RuntimeException e) {
      throw new IOException("ROS 2 cannot start on this machine: " + e, e);
    }
  }

  private static synchronized Participant join(Domain domain, int domainId) throws IOException {
    if (shared == null) {
      domain.setLogLevel(LogLevel.ERROR);
      shared =
          domain.createParticipant(
              ParticipantProfile.create()
                  .domainId(domainId)
                  .name("starl")
                  .useBuiltinTransports(false)
                  .addTransport(udp()));
    }
    users++;
    return shared;
  }

  /**
   * UDP alone. Between processes of one machine Fast DDS prefers shared memory. There a process that is held up for a
   * moment can make its writers wait (eProsima/Fast-DDS#6535), or spin for ever (#6485).
   */
  private static TransportDescriptorType udp() {
    TransportDescriptorType udp = new TransportDescriptorType();
    udp.setTransportId("udp");
    udp.setType("UDPv4");
    return udp;
  }

  private static synchronized void leave(Domain domain, Participant participant) {
    users--;
    if (users == 0) {
      domain.removeParticipant(participant);
      shared = null;
    }
  }

  /** All nodes share the participant's types: one looks and registers at a time. */
  private static synchronized void register(Domain domain, Participant participant, RawType type) {
    if (domain.getRegisteredType(participant, type.getName()) == null) {
      domain.registerType(participant, type);
    }
  }

  /**
   * The library copies its native part into the user's home when it first starts there, and takes a file that exists for a whole
   * one: a second process must wait until the first has copied.
   */
  private static synchronized Domain domain() throws IOException {
    Path folder = Files.createDirectories(Path.of(NativeLibraryLoader.LIBRARY_LOCATION));
    Path file = folder.resolve("starl.lock");
    try (FileChannel channel =
        FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE)) {
      // Until the file is closed.
      channel.lock();
      return DomainFactory.getDefaultDomain();
    }
  }

  /** The number in {@code ROS_DOMAIN_ID}. */
  static int domainId(@Nullable String text) throws IOException {
    String digits = text == null || text.isBlank() ? "0" : text.strip();
    if (!digits.matches("\\d{1,3}") || Integer.parseInt(digits) > MOST_DOMAIN) {
      throw new IOException(
          "ROS_DOMAIN_ID: '" + text + "': expected a whole number from 0 to " + MOST_DOMAIN);
    }
    return Integer.parseInt(digits);
  }

  /**
   * Receives messages on threads of the library.
   *
   * @param isWatched whether to tell why no node sends to it
   * @param consumer may throw a {@link BufferUnderflowException} for a message that is cut off
   */
  void subscribe(RosTopic topic, boolean isWatched, Consumer<Cdr> consumer) throws IOException {
    RosType type = RosType.of(topic.type());
    watched(
        watch(topic, false, isWatched),
        watch -> new Input(topic, type, consumer, watch::matched).open());
  }

  /**
   * Opens an output.
   *
   * @param isWatched whether to tell why no node receives from it
   */
  Output publish(RosTopic topic, boolean isWatched) throws IOException {
    RosType type = RosType.of(topic.type());
    TopicWatch watch = watch(topic, true, isWatched);
    Publisher[] publisher = new Publisher[1];
    watched(watch, opened -> publisher[0] = publisher(topic, type, opened::matched));
    return output(publisher[0], watch);
  }

  @Override
  public void close() {
    guard.run(() -> {
      isClosed = true;
      guard.signal();
    });
    Daemons.join(watcher, 0);
    publishers.forEach(this::remove);
    inputs.forEach(Input::close);
    leave(domain, participant);
  }

  private interface Opening {
    void open(TopicWatch watch) throws IOException;
  }

  private TopicWatch watch(RosTopic topic, boolean isPublisher, boolean isWatched) {
    List<RosType> types = isWatched ? TopicWatch.types(RosType.of(topic.type())) : List.of();
    return new TopicWatch(topic, isPublisher, types, this::probe, this::tell);
  }

  private void watched(TopicWatch watch, Opening opening) throws IOException {
    watch.begin(clock.nowNs());
    opening.open(watch);
    watches.add(watch);
  }

  private Output output(Publisher publisher, TopicWatch watch) {
    return new Output() {
      @Override
      public synchronized void publish(Cdr message) {
        try {
          publisher.write(message.bytes());
        } catch (IOException e) {
          tell(Level.WARN, "cannot publish: " + e.getMessage());
        }
      }

      @Override
      public boolean hasReceiver() {
        return watch.isMatched();
      }
    };
  }

  private void watch() {
    while (!guard.await(() -> isClosed, WATCH_NS)) {
      for (TopicWatch watch : watches) {
        watch.advance(clock.nowNs());
      }
    }
  }

  private void tell(Level level, String line) {
    log.log(clock.nowNs(), level, TAG, line);
  }

  /** Opens an end of a topic that only shows whether it would be matched. */
  private AutoCloseable probe(RosTopic topic, boolean isPublisher, Consumer<Boolean> matched)
      throws IOException {
    RosType type = RosType.of(topic.type());
    if (isPublisher) {
      Publisher publisher = publisher(topic, type, matched);
      return () -> remove(publisher);
    }
    return new Input(topic, type, message -> {}, matched).open();
  }

  private void remove(Publisher publisher) {
    publishers.remove(publisher);
    domain.removePublisher(publisher);
  }

  private Publisher publisher(RosTopic topic, RosType type, Consumer<Boolean> matched)
      throws IOException {
    Publisher publisher =
        domain.createPublisher(
            participant,
            attributes(PublisherAttributes.create(), topic, type),
            (matching, info) -> matched.accept(isMatch(info)));
    publishers.add(publisher);
    return publisher;
  }

  /** A subscriber. */
  private final class Input implements SubscriberListener<byte[][]>, AutoCloseable {

    private final RosTopic topic;
    private final RosType type;
    private final Consumer<Cdr> consumer;
    private final Consumer<Boolean> matched;
    private @Nullable Subscriber<?> subscriber;
    private boolean isOpen;

    Input(RosTopic topic, RosType type, Consumer<Cdr> consumer, Consumer<Boolean> matched) {
      this.topic = topic;
      this.type = type;
      this.consumer = consumer;
      this.matched = matched;
    }

    // The library's interface for creating a subscriber has no type parameters.
    @SuppressWarnings({"unchecked", "rawtypes"})
    Input open() throws IOException {
      subscriber =
          domain.createSubscriber(
              participant,
              attributes(SubscriberAttributes.create(), topic, type),
              (SubscriberListener) this);
      inputs.add(this);
      mayTake(true);
      return this;
    }

    @Override
    public void onNewDataMessage(Subscriber<byte[][]> from) {
      byte[][] bytes = new byte[1][];
      if (isNext(from, bytes)) {
        take(topic, consumer, bytes[0]);
      }
    }

    /**
     * While the library makes or removes a subscriber, it holds a lock that taking a message needs, and waits for the
     * thread that brings one. So none is taken then: of a stream the next one comes soon.
     */
    private synchronized boolean isNext(Subscriber<byte[][]> from, byte[][] bytes) {
      return isOpen && from.takeNextData(bytes, new SampleInfo());
    }

    private synchronized void mayTake(boolean may) {
      isOpen = may;
    }

    @Override
    public void onSubscriptionMatched(Subscriber<byte[][]> from, MatchingInfo info) {
      matched.accept(isMatch(info));
    }

    @Override
    public void close() {
      mayTake(false);
      if (inputs.remove(this)) {
        domain.removeSubscriber(subscriber);
      }
    }
  }

  private void take(RosTopic topic, Consumer<Cdr> consumer, byte[] bytes) {
    try {
      consumer.accept(Cdr.of(bytes));
    } catch (BufferUnderflowException e) {
      tell(Level.WARN, topic.name() + ": a message is cut off");
    }
  }

  private static boolean isMatch(MatchingInfo info) {
    return info.getStatus() == MatchingInfo.MatchingStatus.MATCHED_MATCHING;
  }

  private <A extends CommonAttributes<A>> A attributes(A attributes, RosTopic topic, RosType type) {
    RawType raw = new RawType(type);
    register(domain, participant, raw);
    return attributes
        .topicDataType(raw)
        .topicName("rt" + topic.name())
        .reliabilityKind(
            topic.isReliable()
                ? ReliabilityQosKindPolicyType.RELIABLE
                : ReliabilityQosKindPolicyType.BEST_EFFORT)
        .durabilityKind(
            topic.isTransientLocal()
                ? DurabilityQosKindPolicyType.TRANSIENT_LOCAL
                : DurabilityQosKindPolicyType.VOLATILE)
        .historyQosPolicyKind(HistoryQosKindPolicyType.KEEP_LAST)
        .historyDepth(1);
  }
}
