package org.starl.platform;

/**
 * What a primitive needs when its program starts, so that its robots are not stuck from the start.
 *
 * @param of the primitive, for messages: {@code reach tubes}
 * @param spacingMm the least distance between the centres of two robots at their starts
 * @param clearanceMm the least distance between a centre and the floor's edge or an obstacle; drawn
 *     starts keep it, given ones may be nearer
 * @param positionErrorMm the largest error of a position fix
 * @param answerNs a request and its answer must take less than this time
 */
public record StartNeeds(
    String of, double spacingMm, double clearanceMm, double positionErrorMm, long answerNs) {}
