# Diagnosis: the side from the last vertex to the first is forgotten
def parity(point, vertices):
    x, y = point
    is_inside = False
    for i, (qx, qy) in enumerate(vertices):
        px, py = vertices[max(i - 1, 0)]
        if (py > y) != (qy > y) and x < px + (y - py) / (qy - py) * (qx - px):
            is_inside = not is_inside
    return is_inside
