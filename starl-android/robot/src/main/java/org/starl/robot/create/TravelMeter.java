package org.starl.robot.create;

/** Adds up {@link CreateTravel} from frame to frame; encoder counts wrap around at 16 bits. */
final class TravelMeter {

  private final CreateModel model;
  private CreateTravel travel = CreateTravel.NONE;
  private int left;
  private int right;
  private boolean isKnown;

  TravelMeter(CreateModel model) {
    this.model = model;
  }

  /** After a lost link: the next frame's encoder counts are a new reference, not a path. */
  void lose() {
    isKnown = false;
  }

  CreateTravel add(StreamDecoder frame) {
    if (!model.hasEncoders()) {
      travel = travel.plus(frame.value(Packets.DISTANCE), frame.value(Packets.ANGLE));
      return travel;
    }
    int newLeft = frame.value(Packets.LEFT_ENCODER);
    int newRight = frame.value(Packets.RIGHT_ENCODER);
    if (isKnown) {
      travel =
          travel.plusWheels(
              (short) (newLeft - left) * CreateModel.countMm(),
              (short) (newRight - right) * CreateModel.countMm(),
              model.axleMm());
    }
    left = newLeft;
    right = newRight;
    isKnown = true;
    return travel;
  }
}
